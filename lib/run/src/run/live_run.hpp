#pragma once

#include <chrono>

#include "run/run_messages.hpp"

namespace ddtool {

/// Publishes a run while it is under way: everything as it happens, but the map and the path only about once per second
/// of wall time, or less often where they take long to make.
class LiveRun {
public:
    explicit LiveRun(Ros2Sink& sink, RunMessages::Reader reader = RunMessages::Reader::viewer)
        : messages_(sink, reader) {}

    /// Publishes the map of the run at once, and never again, because it stays as it is.
    void show_fixed_map(std::int64_t stamp_ns, const MapRaster& map);
    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    void add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter);
    /// Publishes the map, unless it is fixed, and the path as they are at the end of the run.
    void finish(const MapRaster& map, const Trajectory& path);

private:
    using Clock = std::chrono::steady_clock;

    void add_map(std::int64_t stamp_ns, const ParticleFilter& filter);

    RunMessages messages_;
    bool map_is_fixed_ = false;
    Clock::time_point map_due_{};
};

}  // namespace ddtool
