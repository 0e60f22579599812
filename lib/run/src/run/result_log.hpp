#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "logs/stream/ros2_writer.hpp"
#include "run/run_messages.hpp"

namespace ddtool {

/// Writes the messages of a run to an MCAP file (docs/formats/results.md). The map and the path are written from time
/// to time only.
class ResultLog {
public:
    explicit ResultLog(const std::filesystem::path& path) : file_(path) {}

    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    void add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter);
    /// Writes the map and the path as they are at the end of the run.
    void finish(const MapRaster& map, const Trajectory& path);
    /// Completes the file. If this is never called, no file is left behind.
    void close() { file_.close(); }

private:
    [[nodiscard]] bool map_is_due(std::int64_t stamp_ns) const;

    Ros2Writer file_;
    RunMessages messages_{file_};
    std::optional<std::int64_t> start_ns_;
    std::int64_t map_written_ns_ = 0;
};

}  // namespace ddtool
