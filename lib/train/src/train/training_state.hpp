#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddtool/system/json_struct.hpp"
#include "train/history.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

/// Sums over the samples seen so far in an epoch.
struct LossSums {
    double loss = 0.0;  ///< of all samples, weighted by class
    double correct = 0.0;
    double count = 0.0;
    double seconds = 0.0;
};
DDTOOL_JSON_STRUCT(LossSums, loss, correct, count, seconds)

/// The state of a training between two steps, without the tensors. Together with the tensors it decides all that
/// follows.
struct TrainingState {
    TrainSettings settings;
    std::string dataset;  ///< fingerprint of the manifest
    std::size_t world_size = 1;
    std::size_t epoch = 0;  ///< finished epochs
    std::size_t step = 0;   ///< finished steps of the epoch under way
    LossSums sums;          ///< of the epoch under way
    std::vector<EpochRecord> history;
};
DDTOOL_JSON_STRUCT(TrainingState, settings, dataset, world_size, epoch, step, sums, history)

/// Returns the epoch with the lowest validation loss so far, or null before the first epoch has finished.
const EpochRecord* best_epoch(const TrainingState& state);

/// Whether the validation loss has not become better for patience_epochs, or all epochs are done.
bool finished(const TrainingState& state);

}  // namespace ddtool::train
