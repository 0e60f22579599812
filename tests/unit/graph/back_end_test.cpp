#include "graph/back_end.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulated_drive.hpp"

namespace ddtool::graph {
namespace {

using namespace test;

/// A ring of corridors, 2 m wide, with a few recesses; once around and a little further.
sim::World ring_world() {
    sim::World world{.name = "ring", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world,
                      {{-1, -1}, {21, -1}, {21, 5}, {21.6, 5}, {21.6, 7}, {21, 7}, {21, 13}, {-1, 13}, {-1, -1}});
    sim::add_polyline(world, {{1, 1}, {19, 1}, {19, 11}, {7, 11}, {7, 10.5}, {5, 10.5}, {5, 11}, {1, 11}, {1, 1}});
    world.route = {.start = {}, .way_points = {{20, 0}, {20, 12}, {0, 12}, {0, 0}, {12, 0}}};
    return world;
}

double largest_error_m(const Trajectory& path, const std::vector<SensorFrame>& frames) {
    const Pose2 path_from_truth = path.front().pose * inverse(*frames.front().world_from_robot);
    double largest = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        largest = std::max(largest, distance_m(path[i].pose, path_from_truth * *frames[i].world_from_robot));
    }
    return largest;
}

std::size_t closed_loops(const Smoothed& result) {
    return static_cast<std::size_t>(
        std::count_if(result.loops.begin(), result.loops.end(), [](const Loop& loop) { return loop.refusal.empty(); }));
}

/// How far apart the places of a closed loop truly are, at most.
double farthest_loop_m(const Smoothed& result, const std::vector<SensorFrame>& frames) {
    const auto truth_at = [&](std::size_t node) {
        const auto frame = std::find_if(frames.begin(), frames.end(), [&](const SensorFrame& each) {
            return each.scan.stamp_ns == result.stamps_ns[node];
        });
        return *frame->world_from_robot;
    };
    double farthest = 0.0;
    for (const Loop& loop : result.loops) {
        if (loop.refusal.empty() && !loop.open_along) {
            const Pose2 truth = between(truth_at(loop.edge.from), truth_at(loop.edge.to));
            farthest = std::max(farthest, distance_m(truth, loop.edge.measured));
        }
    }
    return farthest;
}

/// A path that makes the middle of the first corridor too short, where no end is in sight, as that of a filter that has
/// not closed its loop.
Trajectory drifting_path(const std::vector<SensorFrame>& frames) {
    constexpr double scale = 0.9;
    double way_m = 0.0;
    Trajectory path{{frames.front().scan.stamp_ns, {}}};
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const Pose2 step = between(*frames[i - 1].world_from_robot, *frames[i].world_from_robot);
        way_m += step.x_m;
        path.push_back({frames[i].scan.stamp_ns,
                        path.back().pose *
                            Pose2{(way_m > 8.0 && way_m < 12.0 ? scale : 1.0) * step.x_m, step.y_m, step.theta_rad}});
    }
    return path;
}

TEST(BackEnd, ClosesTheLoopOfARing) {
    const std::vector<SensorFrame> frames = simulated_drive(ring_world(), 8.0);
    const Trajectory open = drifting_path(frames);
    const Smoothed result = back_end_after(frames).finish(open);
    EXPECT_GT(largest_error_m(open, frames), 0.3);
    EXPECT_GE(closed_loops(result), 2U);
    EXPECT_LT(farthest_loop_m(result, frames), 0.1);
    EXPECT_LT(largest_error_m(result.trajectory, frames), 0.2);
    ASSERT_EQ(result.trajectory.size(), frames.size());
    EXPECT_EQ(result.covariances.size(), result.graph.poses.size());
    ASSERT_TRUE(result.map.has_value());
    EXPECT_FALSE(result.map->observed_box().empty());
}

/// The graph does not know the path to be right: between the corridor's ends the odometry moves it a little.
TEST(BackEnd, APathThatIsRightStaysNearlyRight) {
    const std::vector<SensorFrame> frames = simulated_drive(ring_world(), 8.0);
    Trajectory truth;
    for (const SensorFrame& frame : frames) {
        truth.push_back({frame.scan.stamp_ns, *frame.world_from_robot});
    }
    const Smoothed result = back_end_after(frames).finish(truth);
    EXPECT_GE(closed_loops(result), 2U);
    EXPECT_LT(result.loop_error_of_path, 6.0);  // chance gives 3 in the mean
    EXPECT_LT(largest_error_m(result.trajectory, frames), 0.1);
}

TEST(BackEnd, SameRunSameBytes) {
    sim::World world = ring_world();
    world.route.way_points.resize(3);
    const std::vector<SensorFrame> frames = simulated_drive(world, 8.0);
    const Smoothed one = smoothed(frames);
    const Smoothed other = smoothed(frames);
    EXPECT_EQ(one.graph.poses, other.graph.poses);
    EXPECT_EQ(one.covariances, other.covariances);
}

/// Two bare corridors of the same form, side by side, joined at one end: what is seen in one fits in the other.
TEST(BackEnd, CorridorsThatLookAlikeAreNotTakenForOne) {
    sim::World world{.name = "alike", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-1, -1}, {26, -1}, {26, 9}, {-1, 9}, {-1, 7}, {24, 7}, {24, 1}, {-1, 1}, {-1, -1}});
    world.route = {.start = {}, .way_points = {{25, 0}, {25, 8}, {0, 8}}};
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const std::vector<SensorFrame> frames = simulated_drive(world, 8.0, seed);
        EXPECT_EQ(closed_loops(smoothed(frames)), 0U) << seed;
    }
}

TEST(BackEnd, TakesRunsOfNoScanAndOfOne) {
    EXPECT_TRUE(smoothed({}).trajectory.empty());
    sim::World world = ring_world();
    world.route.way_points.resize(1);
    std::vector<SensorFrame> frames = simulated_drive(world, 8.0);
    frames.resize(1);
    const Smoothed result = smoothed(frames);
    ASSERT_EQ(result.trajectory.size(), 1U);
    EXPECT_EQ(result.trajectory.front().pose, frames.front().odom_from_robot);
}

TEST(BackEnd, FramesBehindTheEndOfThePathAreLeftOut) {
    sim::World world = ring_world();
    world.route.way_points.resize(1);
    const std::vector<SensorFrame> frames = simulated_drive(world, 8.0);
    Trajectory path = odometry_path(frames);
    path.resize(path.size() / 2);
    EXPECT_EQ(back_end_after(frames).finish(path).trajectory.size(), path.size());
}

}  // namespace
}  // namespace ddtool::graph
