#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ddtool::train {

/// The values of one step that TensorBoard shows.
struct StepScalars {
    double wall_time_s = 0.0;  ///< since 1970
    std::int64_t step = 0;
    std::vector<std::pair<std::string, double>> values;  ///< tag and value; kept as 32-bit floats
};

/// The bytes of a TensorBoard event file: TFRecords, each a length and an Event message with masked CRC-32C of both
/// (https://www.tensorflow.org/tutorials/load_data/tfrecord, "TFRecords format details").
std::string event_file_of(std::span<const StepScalars> steps);

/// Writes such a file. If it exists and begins with the first of these steps, the others are appended, so that a
/// TensorBoard that has it open can go on reading; otherwise it is replaced. Throws Error naming the file.
void write_event_file(const std::filesystem::path& path, std::span<const StepScalars> steps);

}  // namespace ddtool::train
