#include "check/self_check.hpp"

#include <gtest/gtest.h>

#include "box_scan.hpp"

namespace ddtool::check {
namespace {

using test::seen_from;

/// The true path: so many laps of a circle in the room, a second for each tenth of a radian.
Trajectory laps(double count) {
    Trajectory path;
    for (int step = 0; 0.1 * step < count * 2.0 * std::numbers::pi; ++step) {
        const double angle = 0.1 * step;
        path.push_back({1'000'000'000LL * step,
                        {1.2 * std::cos(angle), 1.2 * std::sin(angle), wrap_angle(angle + std::numbers::pi / 2.0)}});
    }
    return path;
}

/// The evidence of a run that ends with `path`, whose scans were taken on `truth`.
Evidence evidence_of(const Trajectory& path, const Trajectory& truth) {
    SelfCheck check;
    for (std::size_t index = 0; index < truth.size(); ++index) {
        SensorFrame frame = seen_from(truth[index].pose);
        frame.scan.stamp_ns = truth[index].stamp_ns;
        frame.odom_from_robot = path[index].pose;
        check.add(frame, std::nullopt);
    }
    return check.evidence(path);
}

TEST(SelfCheck, ScansOnTheirTruePathAgree) {
    const Trajectory path = laps(2.0);
    const Evidence evidence = evidence_of(path, path);
    EXPECT_EQ(evidence.scans, path.size());
    EXPECT_GT(evidence.neighbours.pairs, 200U);
    EXPECT_GT(evidence.revisits.pairs, 200U);
    EXPECT_EQ(evidence.neighbours.contradicted, 0.0);
    EXPECT_EQ(evidence.revisits.contradicted, 0.0);
    EXPECT_NEAR(evidence.from_odometry_m, 0.0, 1e-9);
}

TEST(SelfCheck, AMapThatTornIsContradictedAtTheTear) {
    const Trajectory truth = laps(2.0);
    Trajectory torn = truth;
    for (std::size_t index = torn.size() / 2; index < torn.size(); ++index) {
        torn[index].pose.x_m += 0.8;
        torn[index].pose.y_m += 0.8;
    }
    const Evidence evidence = evidence_of(torn, truth);
    EXPECT_LT(evidence.neighbours.bad, 0.05);
    EXPECT_GT(evidence.revisits.bad, 0.15);
}

TEST(SelfCheck, APathThatStandsStillIsRefutedByItsScans) {
    const Trajectory truth = laps(2.0);
    Trajectory still = truth;
    for (StampedPose& stamped : still) {
        stamped.pose = truth.front().pose;
    }
    EXPECT_GT(evidence_of(still, truth).revisits.bad, 0.4);
}

TEST(SelfCheck, APathIsComparedWithTheOdometryUpToItsScale) {
    const Trajectory truth = laps(2.0);
    SelfCheck check;
    for (const StampedPose& stamped : truth) {
        SensorFrame frame = seen_from(stamped.pose);
        frame.scan.stamp_ns = stamped.stamp_ns;
        frame.odom_from_robot = Pose2{3.0, 4.0, 1.0} * stamped.pose;
        frame.odom_from_robot.x_m *= 1.1;
        frame.odom_from_robot.y_m *= 1.1;
        check.add(frame, std::nullopt);
    }
    EXPECT_NEAR(check.evidence(truth).from_odometry_m, 0.0, 1e-9);
}

TEST(SelfCheck, ALongRunKeepsABoundedNumberOfScans) {
    SelfCheck check;
    Trajectory path;
    SensorFrame frame = seen_from({});
    for (int step = 0; step < 5000; ++step) {
        frame.scan.stamp_ns = 2'000'000'000LL * step;
        check.add(frame, std::nullopt);
        path.push_back({frame.scan.stamp_ns, {}});
    }
    const Evidence evidence = check.evidence(path);
    EXPECT_LE(evidence.scans, KeptScans::most);
    EXPECT_GE(evidence.scans, KeptScans::most / 2);
    EXPECT_EQ(evidence.revisits.contradicted, 0.0);
}

TEST(SelfCheck, ARunThatEndedEarlyHasFewerPosesThanScans) {
    Trajectory path = laps(1.0);
    const Trajectory truth = path;
    SelfCheck check;
    for (const StampedPose& stamped : truth) {
        SensorFrame frame = seen_from(stamped.pose);
        frame.scan.stamp_ns = stamped.stamp_ns;
        check.add(frame, std::nullopt);
    }
    path.pop_back();
    EXPECT_EQ(check.evidence(path).scans, path.size());
    EXPECT_EQ(check.evidence({}).scans, 0U);
}

}  // namespace
}  // namespace ddtool::check
