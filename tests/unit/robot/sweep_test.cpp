#include "robot/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ddtool/robot/scan_points.hpp"
#include "swept_scans.hpp"

namespace ddtool {
namespace {

using test::SweptScans;

SensorFrame swept_frame(double t_s) {
    SensorFrame frame = SweptScans{}.scan_at(t_s);
    const auto odometry_after = [&](double seconds) { return std::optional(SweptScans::robot_at(t_s + seconds)); };
    frame.sweep = sweep_of(frame.scan, SweptScans::turn_s / SweptScans::beams, odometry_after);
    return frame;
}

/// The largest distance between an end point and the walls of the room.
double farthest_from_walls_m(const SensorFrame& frame, const ScanPointsSettings& settings) {
    const ScanPoints points = scan_points(frame, settings);
    double farthest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point2 end =
            *frame.world_from_robot * Point2{static_cast<double>(points.x_m[i]), static_cast<double>(points.y_m[i])};
        farthest = std::max(farthest, std::min(std::abs(std::abs(end.x_m) - 4.5), std::abs(std::abs(end.y_m) - 3.0)));
    }
    return farthest;
}

TEST(Sweep, PutsTheBeamsOfATurningRobotOnTheWalls) {
    for (const double t_s : {0.0, 0.3, 1.1, 2.0, 4.7}) {
        EXPECT_LT(farthest_from_walls_m(swept_frame(t_s), {}), 0.005) << t_s;
    }
    EXPECT_GT(farthest_from_walls_m(swept_frame(0.0), {.deskew = false}), 0.3);
}

TEST(Sweep, IsFromTheLastBeamToTheFirstForANegativeIncrement) {
    const SensorFrame frame = SweptScans{}.scan_at(1.0);
    const auto straight_on = [](double seconds) { return std::optional(Pose2{seconds, 0.0, 0.0}); };
    const auto forwards = sweep_of(frame.scan, 1e-3, straight_on);
    const auto backwards = sweep_of(frame.scan, -1e-3, straight_on);
    const double duration_s = 1e-3 * (SweptScans::beams - 1);
    EXPECT_DOUBLE_EQ(sweep_duration_s(frame.scan, -1e-3), duration_s);
    for (const std::size_t beam : {std::size_t{0}, std::size_t{17}, SweptScans::beams - 1}) {
        const double measured_s = 1e-3 * static_cast<double>(beam);
        EXPECT_NEAR(pose_in_sweep(forwards, beam, SweptScans::beams).x_m, measured_s, 1e-9);
        EXPECT_NEAR(pose_in_sweep(backwards, beam, SweptScans::beams).x_m, duration_s - measured_s, 1e-9);
    }
}

TEST(Sweep, IsEmptyWhereNothingIsKnown) {
    const SensorFrame frame = SweptScans{}.scan_at(1.0);
    const auto known = [](double) { return std::optional(Pose2{}); };
    EXPECT_TRUE(sweep_of(frame.scan, 0.0, known).empty());
    EXPECT_TRUE(sweep_of({}, 1e-3, known).empty());
    const auto until = [](double seconds) { return seconds < 0.1 ? std::optional(Pose2{}) : std::nullopt; };
    EXPECT_TRUE(sweep_of(frame.scan, 1e-3, until).empty());
}

TEST(Sweep, ReversedBeamsAreTheSameScan) {
    const SensorFrame frame = SweptScans{}.scan_at(0.5);
    LaserScan scan = frame.scan;
    reverse_beams(scan);
    for (std::size_t beam = 0; beam < SweptScans::beams; ++beam) {
        const std::size_t twin = SweptScans::beams - 1 - beam;
        EXPECT_EQ(scan.ranges_m[beam], frame.scan.ranges_m[twin]);
        EXPECT_NEAR(scan.angle_rad(beam), frame.scan.angle_rad(twin), 1e-9);
    }
}

}  // namespace
}  // namespace ddtool
