#pragma once

#include <filesystem>
#include <vector>

#include "ddtool/system/json_struct.hpp"

namespace ddtool::train {

/// The figures of one epoch. The positive class is degenerate.
struct EpochRecord {
    std::uint64_t epoch = 0;     ///< from 1
    double learning_rate = 0.0;  ///< at the last step of the epoch
    double train_loss = 0.0;
    double train_accuracy = 0.0;
    double validation_loss = 0.0;
    double validation_accuracy = 0.0;
    double validation_f1 = 0.0;
    double validation_auc = 0.0;
    double seconds = 0.0;
    double wall_time_s = 0.0;  ///< the end of the epoch, in seconds since 1970
    bool operator==(const EpochRecord&) const = default;
};
DDTOOL_JSON_STRUCT(EpochRecord, epoch, learning_rate, train_loss, train_accuracy, validation_loss, validation_accuracy,
                   validation_f1, validation_auc, seconds, wall_time_s)

inline constexpr const char* event_file_name = "events.out.tfevents.ddtool";

/// Writes metrics.csv, metrics.json, curves.png and TensorBoard's event file of all epochs so far into the folder. New
/// epochs are appended to the event file, so that a TensorBoard that has it open sees them; the other files are
/// replaced. The same epochs give the same bytes. Throws Error naming the file.
void write_history(const std::filesystem::path& folder, const std::vector<EpochRecord>& epochs);

}  // namespace ddtool::train
