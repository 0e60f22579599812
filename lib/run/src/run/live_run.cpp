#include "run/live_run.hpp"

#include <algorithm>

namespace ddtool {
namespace {

constexpr std::chrono::seconds least_map_interval{1};
/// After a map has been made and sent, the next one waits for this many times as long as that took. So maps take at
/// most one part in 21 of the run's time.
constexpr int map_time_share = 20;

}  // namespace

void LiveRun::show_fixed_map(std::int64_t stamp_ns, const MapRaster& map) {
    map_is_fixed_ = true;
    messages_.add_map(stamp_ns, map);
}

void LiveRun::add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter) {
    if (update) {
        messages_.add(frame, *update);
        add_map(frame.scan.stamp_ns, filter);
    }
    messages_.add_pose(frame.scan.stamp_ns, filter);
}

void LiveRun::finish(const MapRaster& map, const Trajectory& path) {
    if (path.empty()) {
        return;
    }
    if (!map_is_fixed_) {
        messages_.add_map(path.back().stamp_ns, map);
    }
    messages_.add_path(path.back().stamp_ns, path);
}

void LiveRun::add_map(std::int64_t stamp_ns, const ParticleFilter& filter) {
    const Clock::time_point start = Clock::now();
    if (start < map_due_) {
        return;
    }
    if (!map_is_fixed_) {
        messages_.add_map(stamp_ns, map_raster(filter.map()));
    }
    messages_.add_path(stamp_ns, filter);
    const Clock::time_point end = Clock::now();
    map_due_ = end + std::max<Clock::duration>(least_map_interval, map_time_share * (end - start));
}

}  // namespace ddtool
