#include "drives.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/methods/method.hpp"
#include "scores/absolute_error.hpp"
#include "sim/world_catalogue.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::localization_bench {
namespace {

/// A ring of corridors, 2 m wide, whose sides look alike but for a few recesses; twice around.
sim::World ring_world() {
    sim::World world{.name = "ring", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world,
                      {{-1, -1}, {10, -1}, {10, -1.6}, {12, -1.6}, {12, -1}, {21, -1}, {21, 13}, {-1, 13}, {-1, -1}});
    sim::add_polyline(world, {{1, 1}, {19, 1}, {19, 11}, {7, 11}, {7, 10.5}, {5, 10.5}, {5, 11}, {1, 11}, {1, 1}});
    world.route = {.start = {}, .way_points = {{20, 0}, {20, 12}, {0, 12}, {0, 0}, {20, 0}, {20, 12}, {0, 12}, {0, 0}}};
    return world;
}

class Frames : public SensorStream {
public:
    explicit Frames(const std::vector<SensorFrame>& frames) : frames_(frames) {}
    std::optional<SensorFrame> next() override {
        return next_ < frames_.size() ? std::optional(frames_[next_++]) : std::nullopt;
    }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    const std::vector<SensorFrame>& frames_;
    std::size_t next_ = 0;
};

}  // namespace

Pose2 MadeMap::in_map(const Pose2& world_from_robot) const {
    const Pose& nearest = *std::ranges::min_element(
        path, {}, [&](const Pose& pose) { return distance_m(pose.world_from_robot, world_from_robot); });
    return nearest.map_from_robot * between(nearest.world_from_robot, world_from_robot);
}

Place place_of(const std::string& name) {
    const std::size_t at = name.find('@');
    const std::string world = name.substr(0, at);
    return {.name = name,
            .world = world == "ring" ? ring_world() : sim::load_world(world),
            .range_m = at == std::string::npos ? 30.0 : std::stod(name.substr(at + 1))};
}

sim::Simulation drive_of(const Place& place, std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lidar.beams = 360;
    settings.lidar.range_max_m = place.range_m;
    return {place.world, settings};
}

std::vector<SensorFrame> frames_of(const sim::Simulation& drive) {
    std::vector<SensorFrame> frames;
    for (std::size_t index = 0; index < drive.frame_count(); ++index) {
        frames.push_back(drive.frame(index).frame);
    }
    return frames;
}

MadeMap map_of(const std::vector<SensorFrame>& frames) {
    ThreadPool threads(1);
    const std::unique_ptr<ParticleFilter> filter = make_filter({}, {}, threads);
    Frames stream(frames);
    const FilterRun run =
        run_filter(stream, *filter, [](const SensorFrame&, const std::optional<Update>&) { return true; });
    const AteResult error = absolute_trajectory_error(run.trajectory, run.ground_truth);
    std::vector<MadeMap::Pose> path;
    for (std::size_t index = 0; index < run.trajectory.size(); ++index) {
        path.push_back({run.ground_truth[index].pose, run.trajectory[index].pose});
    }
    return {
        .grid = std::make_shared<const OccupancyGrid>(run.map),
        .path = std::move(path),
        .map_from_world = inverse(error.reference_from_estimate),
        .ate_m = error.translation_m.rmse,
        .ate_from_start_m = absolute_trajectory_error(run.trajectory, run.ground_truth, {.alignment = Alignment::first})
                                .translation_m.rmse};
}

MadeMap true_map_of(const std::vector<SensorFrame>& frames) {
    OccupancyGrid grid({});
    ScanInserter inserter;
    const Pose2 map_from_world = inverse(*frames.front().world_from_robot);
    Pose2 last{1e9, 0.0, 0.0};
    std::vector<MadeMap::Pose> path;
    for (const SensorFrame& frame : frames) {
        const Pose2 pose = map_from_world * *frame.world_from_robot;
        path.push_back({*frame.world_from_robot, pose});
        constexpr double entry_m = 0.3;
        constexpr double entry_rad = 0.3;
        if (distance_m(last, pose) > entry_m || std::abs(wrap_angle(last.theta_rad - pose.theta_rad)) > entry_rad) {
            inserter.insert(grid, scan_points(frame, {}), pose);
            last = pose;
        }
    }
    return {.grid = std::make_shared<const OccupancyGrid>(std::move(grid)),
            .path = std::move(path),
            .map_from_world = map_from_world};
}

void write_map(const std::filesystem::path& folder, const Place& place, const MadeMap& map) {
    const CellBox box = map.grid->observed_box();
    const double cell_m = map.grid->cell_size_m();
    write_file(folder / (place.name + ".map"), [&](std::ostream& out) {
        out << cell_m << ' ' << box.x_max - box.x_min << ' ' << box.y_max - box.y_min << ' ' << box.x_min * cell_m
            << ' ' << box.y_min * cell_m << '\n';
        for (int y = box.y_min; y < box.y_max; ++y) {
            for (int x = box.x_min; x < box.x_max; ++x) {
                const std::int8_t odds = map.grid->log_odds({x, y});
                out << (odds == Patch::unknown ? '?' : odds > 0 ? '#' : '.');
            }
            out << '\n';
        }
    });
}

void write_drive(const std::filesystem::path& folder, const Place& place, const MadeMap& map, std::uint64_t seed,
                 const std::vector<SensorFrame>& frames) {
    write_file(folder / (place.name + "-" + std::to_string(seed) + ".drive"), [&](std::ostream& out) {
        out.precision(9);
        const auto write_pose = [&](const Pose2& pose) {
            out << pose.x_m << ' ' << pose.y_m << ' ' << pose.theta_rad << ' ';
        };
        for (const SensorFrame& frame : frames) {
            const ScanPoints points = scan_points(frame, {});
            write_pose(frame.odom_from_robot);
            write_pose(map.map_from_world * *frame.world_from_robot);
            out << points.size();
            for (std::size_t i = 0; i < points.size(); ++i) {
                out << ' ' << points.x_m[i] << ' ' << points.y_m[i];
            }
            out << '\n';
        }
    });
}

}  // namespace ddtool::localization_bench
