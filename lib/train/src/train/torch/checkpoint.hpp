#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/network/model_description.hpp"
#include "train/history.hpp"
#include "train/torch/network.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train_torch {

/// Sums over the samples seen so far in an epoch.
struct LossSums {
    double loss = 0.0;  ///< of all samples, weighted by class
    double correct = 0.0;
    double count = 0.0;
    double seconds = 0.0;
};
DDTOOL_JSON_STRUCT(LossSums, loss, correct, count, seconds)

/// Where a training stands between two steps, tensors apart: with the tensors, all that the rest of it depends on.
struct TrainingState {
    train::TrainSettings settings;
    std::string dataset;  ///< fingerprint of the manifest
    std::size_t world_size = 1;
    std::size_t epoch = 0;  ///< finished epochs
    std::size_t step = 0;   ///< finished steps of the epoch under way
    LossSums sums;          ///< of the epoch under way
    std::vector<train::EpochRecord> history;
};
DDTOOL_JSON_STRUCT(TrainingState, settings, dataset, world_size, epoch, step, sums, history)

/// The epoch of the least validation loss so far, none before the first.
const train::EpochRecord* best_epoch(const TrainingState& state);

/// Whether the validation loss has not become better for patience_epochs, or all epochs are done.
bool finished(const TrainingState& state);

/// Writes network and description, and with `state` and `optimizer` all that going on needs (weights, optimiser,
/// random state, place in the data), as LibTorch's archive. The old file stays until the new one is whole. Throws Error
/// naming the file.
void write_checkpoint(const std::filesystem::path& path, const Network& network,
                      const native::ModelDescription& description);
void write_checkpoint(const std::filesystem::path& path, const Network& network,
                      const native::ModelDescription& description, const torch::optim::Optimizer& optimizer,
                      const TrainingState& state);

/// A checkpoint that was opened. Every member throws Error naming the file where it is damaged.
class Checkpoint {
public:
    /// Its tensors go to the device, and so does what is restored from it.
    explicit Checkpoint(const std::filesystem::path& path, torch::Device device = torch::kCPU);

    [[nodiscard]] native::ModelDescription description();
    /// The network in float32.
    [[nodiscard]] std::shared_ptr<Network> network();
    /// Where the training stood. Throws Error for a checkpoint without it, such as the best one.
    [[nodiscard]] TrainingState state();
    /// Takes weights, optimiser and LibTorch's random state over.
    void restore(Network& network, torch::optim::Optimizer& optimizer);

private:
    [[nodiscard]] std::string text(const char* key);
    template <typename Action>
    auto guarded(Action&& action);

    std::filesystem::path path_;
    torch::serialize::InputArchive archive_;
};

}  // namespace ddtool::train_torch
