#pragma once

#include <filesystem>
#include <vector>

#include "base/json_struct.hpp"

namespace ddtool::learning {

/// One epoch's figures. The positive class is degenerate.
struct EpochRecord {
    std::uint64_t epoch = 0;     ///< from 1
    double learning_rate = 0.0;  ///< of its last step
    double train_loss = 0.0;
    double train_accuracy = 0.0;
    double validation_loss = 0.0;
    double validation_accuracy = 0.0;
    double validation_f1 = 0.0;
    double validation_auc = 0.0;
    double seconds = 0.0;
    bool operator==(const EpochRecord&) const = default;
};
DDTOOL_JSON_STRUCT(EpochRecord, epoch, learning_rate, train_loss, train_accuracy, validation_loss, validation_accuracy,
                   validation_f1, validation_auc, seconds)

/// Writes metrics.csv, metrics.json, curves.png and a TensorBoard event file (events.out.tfevents.*) of all epochs so
/// far into the folder, each replaced as a whole. Throws Error naming the file.
void write_history(const std::filesystem::path& folder, const std::vector<EpochRecord>& epochs);

}  // namespace ddtool::learning
