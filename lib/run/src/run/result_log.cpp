#include "run/result_log.hpp"

#include <algorithm>

namespace ddtool {
namespace {

/// A map is written when the run has become a tenth longer since the last one, but at most every 10 s of the log.
constexpr std::int64_t least_map_interval_ns = 10'000'000'000;
constexpr std::int64_t map_interval_share = 10;

}  // namespace

void ResultLog::add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    if (update) {
        messages_.add(frame, *update);
        if (map_is_due(stamp_ns)) {
            messages_.add_map(stamp_ns, map_raster(filter.map()));
            messages_.add_path(stamp_ns, filter);
            map_written_ns_ = stamp_ns;
        }
        start_ns_ = start_ns_.value_or(stamp_ns);
    }
    messages_.add_pose(stamp_ns, filter);
}

void ResultLog::finish(const MapRaster& map, const Trajectory& path) {
    const std::int64_t stamp_ns = path.empty() ? 0 : path.back().stamp_ns;
    messages_.add_map(stamp_ns, map);
    messages_.add_path(stamp_ns, path);
}

/// Because the intervals grow with the run, the file holds a few dozen maps even if the run is long.
bool ResultLog::map_is_due(std::int64_t stamp_ns) const {
    if (!start_ns_) {
        return true;
    }
    const std::int64_t interval_ns =
        std::max(least_map_interval_ns, (map_written_ns_ - *start_ns_) / map_interval_share);
    return stamp_ns - map_written_ns_ >= interval_ns;
}

}  // namespace ddtool
