#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "logs/stream/ros2_writer.hpp"
#include "run/run_messages.hpp"

namespace ddtool {

/// The messages of a run in an MCAP file (docs/formats/results.md), now and then with the map and the path.
class ResultLog {
public:
    explicit ResultLog(const std::filesystem::path& path) : file_(path) {}

    /// After the filter has taken the frame, with the update where there was one.
    void add(const SensorFrame& frame, const std::optional<Update>& update, const Rbpf& filter);
    /// The map and the path as they are at the end.
    void finish(const MapRaster& map, const Trajectory& path);
    /// Completes the file; without it nothing is left behind.
    void close() { file_.close(); }

private:
    [[nodiscard]] bool map_is_due(std::int64_t stamp_ns) const;

    Ros2Writer file_;
    RunMessages messages_{file_};
    std::optional<std::int64_t> start_ns_;
    std::int64_t map_written_ns_ = 0;
};

}  // namespace ddtool
