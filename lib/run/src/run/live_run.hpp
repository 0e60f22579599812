#pragma once

#include <chrono>

#include "run/run_messages.hpp"

namespace ddtool {

/// Tells of a run while it goes on: everything as it happens, and the map and the path about once a second of wall
/// time, less often where they take long to make.
class LiveRun {
public:
    explicit LiveRun(Ros2Sink& sink) : messages_(sink) {}

    /// After the filter has taken the frame, with the update where there was one.
    void add(const SensorFrame& frame, const std::optional<Update>& update, const Rbpf& filter);
    /// The map and the path as they are at the end.
    void finish(const MapRaster& map, const Trajectory& path);

private:
    using Clock = std::chrono::steady_clock;

    void add_map(std::int64_t stamp_ns, const Rbpf& filter);

    RunMessages messages_;
    Clock::time_point map_due_{};
};

}  // namespace ddtool
