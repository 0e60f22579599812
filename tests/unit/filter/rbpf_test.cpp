#include "ddtool/filter/rbpf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "room_run.hpp"

namespace ddtool {
namespace {

double largest_error_m(const Trajectory& trajectory, const std::vector<SensorFrame>& frames) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        largest = std::max(largest, distance_m(trajectory[i].pose, *frames[i].world_from_robot));
    }
    return largest;
}

std::vector<SensorFrame> without_returns(std::vector<SensorFrame> frames) {
    for (SensorFrame& frame : frames) {
        std::fill(frame.scan.ranges_m.begin(), frame.scan.ranges_m.end(), LaserScan::no_return);
    }
    return frames;
}

/// The poses that follow from odometry alone.
Trajectory by_odometry(const std::vector<SensorFrame>& frames) {
    Trajectory trajectory;
    for (const SensorFrame& frame : frames) {
        trajectory.push_back({frame.scan.stamp_ns, frame.odom_from_robot});
    }
    return trajectory;
}

TEST(Rbpf, KnowsWhereItIsInARoomBetterThanOdometryDoes) {
    const std::vector<SensorFrame>& frames = room_drive();
    const Trajectory trajectory = filtered(frames, few_particles());
    expect_finite_pose_for_every_scan(trajectory, frames);
    EXPECT_LT(largest_error_m(trajectory, frames), 0.06);
    EXPECT_LT(largest_error_m(trajectory, frames), 0.7 * largest_error_m(by_odometry(frames), frames));
}

TEST(Rbpf, OneParticleIsAFilterToo) {
    EXPECT_LT(largest_error_m(filtered(room_drive(), few_particles(1)), room_drive()), 0.06);
}

TEST(Rbpf, IsTheSameBytesOnAnyNumberOfThreads) {
    RbpfSettings settings = few_particles();
    settings.resample_share = 0.9;
    const std::vector<Pose2> one = poses_of(filtered(room_drive(), settings));
    EXPECT_EQ(poses_of(filtered(room_drive(), settings, {}, 2)), one);
    EXPECT_EQ(poses_of(filtered(room_drive(), settings, {}, 3)), one);
    settings.seed = 2;
    EXPECT_NE(poses_of(filtered(room_drive(), settings)), one);
}

TEST(Rbpf, StartsWhereOdometryDoes) {
    std::vector<SensorFrame> frames = room_drive();
    const Pose2 motion{-30.0, 12.0, 2.0};
    for (SensorFrame& frame : frames) {
        frame.odom_from_robot = motion * frame.odom_from_robot;
        frame.world_from_robot = motion * *frame.world_from_robot;
    }
    const Trajectory trajectory = filtered(frames, few_particles());
    EXPECT_EQ(trajectory.front().pose, frames.front().odom_from_robot);
    EXPECT_LT(largest_error_m(trajectory, frames), 0.08);
}

TEST(Rbpf, StampsDecideNothing) {
    std::vector<SensorFrame> frames = room_drive();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].scan.stamp_ns = 1'000'000'000 - static_cast<std::int64_t>(i) * 7;
    }
    const Trajectory trajectory = filtered(frames, few_particles());
    expect_finite_pose_for_every_scan(trajectory, frames);
    EXPECT_EQ(poses_of(trajectory), poses_of(filtered(room_drive(), few_particles())));
}

TEST(Rbpf, ThatNeverMovesKeepsItsPlace) {
    const std::vector<SensorFrame> frames(20, room_drive().front());
    ThreadPool threads(1);
    Rbpf filter(few_particles(), threads);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(filter.update(frames[i]).has_value(), i == 0);
        EXPECT_EQ(filter.pose(), frames.front().odom_from_robot);
    }
    expect_finite_pose_for_every_scan(filter.trajectory(), frames);
}

TEST(Rbpf, WithoutReturnsFollowsTheMotionModel) {
    const std::vector<SensorFrame> frames = without_returns(room_drive());
    RbpfSettings settings = few_particles(1);
    settings.motion = {0.0, 0.0, 0.0, 0.0};
    const Trajectory trajectory = filtered(frames, settings);
    expect_finite_pose_for_every_scan(trajectory, frames);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_LT(distance_m(trajectory[i].pose, frames[i].odom_from_robot), 1e-9) << i;
    }
    expect_finite_pose_for_every_scan(filtered(frames, few_particles()), frames);
}

TEST(Rbpf, StaysFiniteWhenOdometryJumps) {
    std::vector<SensorFrame> frames = room_drive();
    for (std::size_t i = frames.size() / 2; i < frames.size(); ++i) {
        frames[i].odom_from_robot = Pose2{100.0, -40.0, 1.0} * frames[i].odom_from_robot;
    }
    expect_finite_pose_for_every_scan(filtered(frames, few_particles()), frames);
}

/// A drive in which one scan fits nowhere, and after it the odometry is off by `slip`: as in a pause of the scans in
/// which the robot turns.
double error_after_slip_m(std::size_t garbled, const Pose2& slip) {
    std::vector<SensorFrame> frames = room_drive();
    for (std::size_t beam = 0; beam < frames[garbled].scan.ranges_m.size(); ++beam) {
        frames[garbled].scan.ranges_m[beam] = 0.5F + 0.3F * static_cast<float>(beam % 7);
    }
    const Pose2 before = frames[garbled].odom_from_robot;
    for (std::size_t i = garbled + 1; i < frames.size(); ++i) {
        frames[i].odom_from_robot = before * slip * between(before, frames[i].odom_from_robot);
    }
    return distance_m(filtered(frames, few_particles()).back().pose, *frames.back().world_from_robot);
}

/// In both cases a search of headings first and places after ends with a map that is torn by more than a metre.
TEST(Rbpf, FindsTheMapAgainAfterAScanThatFitsNowhere) {
    ASSERT_EQ(room_drive().size(), 99U);
    EXPECT_LT(error_after_slip_m(49, {0.5, -0.5, -0.33}), 0.05);
    EXPECT_LT(error_after_slip_m(66, {0.5, 0.5, 0.33}), 0.05);
}

TEST(Rbpf, BeforeTheFirstScanHasNoTrajectory) { EXPECT_TRUE(filtered({}, few_particles()).empty()); }

/// The last pose of the trajectory is the pose that the filter reported for the last scan, because nothing later could
/// have corrected it.
TEST(Rbpf, TrajectoryEndsAtThePresentPose) {
    ThreadPool threads(1);
    Rbpf filter(few_particles(), threads);
    for (const SensorFrame& frame : room_drive()) {
        filter.update(frame);
        ASSERT_LT(distance_m(filter.trajectory().back().pose, filter.pose()), 1e-12);
    }
}

/// A straight drive of many updates in which the lidar sees nothing.
std::vector<SensorFrame> long_drive(std::size_t updates) {
    std::vector<SensorFrame> frames(updates, without_returns({room_drive().front()}).front());
    for (std::size_t i = 0; i < updates; ++i) {
        frames[i].scan.stamp_ns = static_cast<std::int64_t>(i);
        frames[i].odom_from_robot = {0.2 * static_cast<double>(i), 0.0, 0.0};
    }
    return frames;
}

/// The filter settles the common past at every 1024th update and leaves the last 1024 updates as they are.
TEST(Rbpf, ThePastThatAllParticlesShareStaysAsItWas) {
    const std::vector<SensorFrame> frames = long_drive(2'300);
    RbpfSettings settings = few_particles(3);
    settings.resample_share = 1.1;  // resamples at every update, so that the particles soon have a common ancestor
    ThreadPool threads(1);
    Rbpf filter(settings, threads);
    std::vector<Pose2> before;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        filter.update(frames[i]);
        if (i == 2'040) {
            before = poses_of(filter.trajectory());
        }
    }
    expect_finite_pose_for_every_scan(filter.trajectory(), frames);
    std::vector<Pose2> after = poses_of(filter.trajectory());
    EXPECT_EQ(after.back(), filter.pose());
    before.resize(1'990);
    after.resize(before.size());
    EXPECT_EQ(after, before);
}

/// Without resampling: three particles whose paths have no common ancestor, and a single particle.
TEST(Rbpf, NoLongDriveLosesAPose) {
    const std::vector<SensorFrame> frames = long_drive(2'300);
    for (const std::size_t particles : {1U, 3U}) {
        RbpfSettings settings = few_particles(particles);
        settings.resample_share = 0.0;
        expect_finite_pose_for_every_scan(filtered(frames, settings), frames);
    }
}

/// In a known map the pose is at the place that weighs most, although the heaviest particle stands elsewhere.
TEST(Rbpf, APlaceOfManyParticlesOutweighsAHeavyOne) {
    const auto map = std::make_shared<OccupancyGrid>(OccupancySettings{});
    ScanInserter().insert(*map, scan_points(room_drive().front(), {}), {});
    ThreadPool threads(1);
    Rbpf filter(few_particles(), threads, {}, map);
    std::vector<Hypothesis> places{{.pose = {3.0, 0.0, 0.0}, .log_weight = std::log(0.4)}};
    for (const double x_m : {0.0, 0.01, 0.02}) {
        places.push_back({.pose = {x_m, 0.0, 0.0}, .log_weight = std::log(0.2)});
    }
    filter.place(places, 0.0);
    EXPECT_EQ(filter.best().pose, Pose2{});
}

}  // namespace
}  // namespace ddtool
