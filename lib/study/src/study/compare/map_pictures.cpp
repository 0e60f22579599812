#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "ddtool/filter/scan_insertion.hpp"
#include "report/map_raster.hpp"
#include "study/compare/run_pictures.hpp"

namespace ddtool::compare {
namespace {

constexpr double step_m = 0.2;
constexpr double step_rad = 0.2;

bool has_moved(const Pose2& from, const Pose2& to) {
    const Pose2 motion = between(from, to);
    return std::hypot(motion.x_m, motion.y_m) >= step_m || std::abs(motion.theta_rad) >= step_rad;
}

/// The map that results from a log's scans at the poses of a trajectory. It is computed in the same way for every
/// method, so the maps of two methods differ only because their trajectories do.
class TrajectoryMap {
public:
    /// The poses are world_from_robot and may be in any order of time.
    explicit TrajectoryMap(Trajectory trajectory) : sorted_(std::move(trajectory)) {
        std::stable_sort(sorted_.begin(), sorted_.end(),
                         [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
    }

    /// Enters the frame's scan if the robot has moved since the last scan that was entered. Frames before the start or
    /// after the end of the trajectory are left out.
    void add(const SensorFrame& frame) {
        const std::optional<Pose2> pose = pose_at(sorted_, frame.scan.stamp_ns);
        if (pose && (!last_ || has_moved(*last_, *pose))) {
            inserter_.insert(grid_, scan_points(frame, ScanPointsSettings{}), *pose);
            last_ = pose;
        }
    }
    [[nodiscard]] const OccupancyGrid& grid() const { return grid_; }

private:
    Trajectory sorted_;
    OccupancyGrid grid_{OccupancySettings{}};
    ScanInserter inserter_;
    std::optional<Pose2> last_;
};

report::Range x_of(const MapRaster& map) { return {map.origin_m.x_m, map.origin_m.x_m + map.width_m()}; }
report::Range y_of(const MapRaster& map) { return {map.origin_m.y_m, map.origin_m.y_m + map.height_m()}; }

struct NamedMap {
    std::string title;
    MapRaster raster;
};

/// Makes all maps in one pass over the data. The map of the true trajectory comes first.
std::vector<NamedMap> maps_of(const ShownRun& run) {
    std::vector<TrajectoryMap> maps;
    std::vector<NamedMap> named;
    if (!run.truth.empty()) {
        maps.emplace_back(run.truth);
        named.push_back({"truth", {}});
    }
    for (const ShownEstimate& estimate : run.estimates) {
        maps.emplace_back(estimate.trajectory);
        named.push_back({estimate.title(), {}});
    }
    const std::unique_ptr<SensorStream> stream = run.data->open([](const LogProblem&) {});
    while (const std::optional<SensorFrame> frame = stream->next()) {
        std::for_each(maps.begin(), maps.end(), [&](TrajectoryMap& map) { map.add(*frame); });
    }
    for (std::size_t index = 0; index < maps.size(); ++index) {
        named[index].raster = map_raster(maps[index].grid());
    }
    return named;
}

}  // namespace

void draw_maps(const std::filesystem::path& file, const ShownRun& run) {
    const std::vector<NamedMap> maps = maps_of(run);
    Extent extent;
    for (const NamedMap& map : maps) {
        extent.x.include(x_of(map.raster).low);
        extent.x.include(x_of(map.raster).high);
        extent.y.include(y_of(map.raster).low);
        extent.y.include(y_of(map.raster).high);
    }
    write_side_by_side(file, extent, maps.size(), [&](report::Axes& axes, std::size_t panel) {
        const MapRaster& map = maps[panel].raster;
        const std::vector<std::uint8_t> pixels = map_pixels(map);
        const std::array<std::uint8_t, 1> unknown_pixel{map_grey(MapRaster::unknown)};
        axes.title(maps[panel].title);
        axes.picture({.width_px = 1, .height_px = 1, .channels = 1, .pixels = unknown_pixel}, extent.x, extent.y);
        axes.picture({.width_px = map.width, .height_px = map.height, .channels = 1, .pixels = pixels}, x_of(map),
                     y_of(map));
    });
}

}  // namespace ddtool::compare
