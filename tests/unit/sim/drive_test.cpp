#include "sim/drive.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

constexpr std::int64_t start_ns = 1'000'000'000;
constexpr std::int64_t drive_step_ns = 10'000'000;
constexpr double step_s = 0.01;

const Route zigzag{
    .start = {1.0, 2.0, 0.5}, .way_points = {{6.0, 2.0}, {6.0, 8.0}, {0.0, 7.5}, {9.0, 9.0}, {12.0, 8.0}}, .laps = 1.0};

struct Speeds {
    double along;
    double turning;
};

/// The speeds in the robot's frame, over each step.
std::vector<Speeds> speeds_of(const Trajectory& trajectory) {
    std::vector<Speeds> speeds;
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
        const Pose2 motion = between(trajectory[i - 1].pose, trajectory[i].pose);
        speeds.push_back({std::hypot(motion.x_m, motion.y_m) / step_s, motion.theta_rad / step_s});
    }
    return speeds;
}

TEST(Drive, PassesEveryWayPointAndStopsAtTheLast) {
    const Trajectory trajectory = drive(zigzag, {}, start_ns, drive_step_ns);
    for (const Point2& way_point : zigzag.way_points) {
        double nearest_m = 1e9;
        for (const StampedPose& stamped : trajectory) {
            nearest_m =
                std::min(nearest_m, std::hypot(stamped.pose.x_m - way_point.x_m, stamped.pose.y_m - way_point.y_m));
        }
        EXPECT_LT(nearest_m, 0.1) << way_point.x_m << ", " << way_point.y_m;
    }
    EXPECT_NEAR(trajectory.back().pose.x_m, 12.0, 0.05);
    EXPECT_NEAR(trajectory.back().pose.y_m, 8.0, 0.05);
}

TEST(Drive, KeepsTheLimitsOfTheRobot) {
    const DriveSettings settings;
    const std::vector<Speeds> speeds = speeds_of(drive(zigzag, settings, start_ns, drive_step_ns));
    constexpr double rounding = 1e-6;
    Speeds last{0.0, 0.0};
    for (const Speeds& now : speeds) {
        EXPECT_LE(now.along, settings.speed_m_per_s + rounding);
        EXPECT_LE(std::abs(now.turning), settings.turn_rate_rad_per_s + rounding);
        EXPECT_LE(std::abs(now.along - last.along), settings.acceleration_m_per_s2 * step_s + rounding);
        EXPECT_LE(std::abs(now.turning - last.turning), settings.turn_acceleration_rad_per_s2 * step_s + rounding);
        last = now;
    }
    EXPECT_LE(last.along, settings.acceleration_m_per_s2 * step_s + rounding);
}

TEST(Drive, NeverMovesSideways) {
    const Trajectory trajectory = drive(zigzag, {}, start_ns, drive_step_ns);
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
        // The chord of an arc has the direction of half the turn.
        const Pose2 motion = between(trajectory[i - 1].pose, trajectory[i].pose);
        EXPECT_NEAR(motion.y_m, motion.x_m * std::tan(motion.theta_rad / 2.0), 1e-9);
    }
}

TEST(Drive, TurnsInPlaceAtASharpCorner) {
    const Route there_and_back{.start = {}, .way_points = {{5.0, 0.0}, {0.0, 0.0}}};
    double turned_rad = 0.0;
    for (const Speeds& now : speeds_of(drive(there_and_back, {}, start_ns, drive_step_ns))) {
        turned_rad += now.along < 1e-9 ? std::abs(now.turning) * step_s : 0.0;
    }
    EXPECT_GT(turned_rad, 0.9 * std::numbers::pi);
}

TEST(Drive, StampsEveryStep) {
    const Trajectory trajectory = drive(zigzag, {}, start_ns, drive_step_ns);
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        ASSERT_EQ(trajectory[i].stamp_ns, start_ns + static_cast<std::int64_t>(i) * drive_step_ns);
    }
}

TEST(Drive, MovesWithTheRoute) {
    const Pose2 moved_from_world{20.0, -5.0, 1.3};
    Route moved = zigzag;
    moved.start = moved_from_world * zigzag.start;
    for (Point2& point : moved.way_points) {
        point = moved_from_world * point;
    }
    const Trajectory here = drive(zigzag, {}, start_ns, drive_step_ns);
    const Trajectory there = drive(moved, {}, start_ns, drive_step_ns);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); i += 50) {
        EXPECT_NEAR(distance_m(moved_from_world * here[i].pose, there[i].pose), 0.0, 1e-6);
    }
}

TEST(Drive, LapsRepeatTheWayPoints) {
    Route square{.start = {}, .way_points = {{4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {0.0, 0.0}}};
    square.laps = 1.5;
    const Pose2 end = drive(square, {}, start_ns, drive_step_ns).back().pose;
    EXPECT_NEAR(end.x_m, 4.0, 0.05);
    EXPECT_NEAR(end.y_m, 4.0, 0.05);
}

std::string drive_refusal(const Route& route, const DriveSettings& settings) {
    try {
        drive(route, settings, start_ns, drive_step_ns);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Drive, SaysWhichWayPointIsOutOfReach) {
    const Route route{.start = {}, .way_points = {{2.0, 0.0}, {2.0, 2.0}}};
    // The robot turns too slowly: it drifts sideways off the second leg, or never comes to face it.
    const DriveSettings sideways{.turn_rate_rad_per_s = 0.05, .turn_in_place_above_rad = 4.0, .lookahead_m = 0.1};
    EXPECT_THAT(drive_refusal(route, sideways), testing::HasSubstr("way point 2"));
    EXPECT_THAT(drive_refusal(route, {.turn_rate_rad_per_s = 1e-3}), testing::HasSubstr("way point 2"));
}

TEST(Drive, RefusesARobotThatCannotMove) {
    EXPECT_THAT(drive_refusal(zigzag, {.speed_m_per_s = 0.0}), testing::HasSubstr("above 0"));
}

}  // namespace
}  // namespace ddtool::sim
