#include "logs/stream/way_scale.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "room_scan.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A drive to and fro in a room, with scans at 5 Hz by a lidar that looks to the left, and odometry at 20 Hz.
class Way : public testing::Test {
protected:
    void drive(double scale, double speed_m_per_s = 0.3, const test::Room& room = {}, double seconds = 60.0) {
        RandomStream random({5});
        scans_ = {};
        odometry_ = {};
        const auto robot = [&](double t_s) {
            const double way_m = speed_m_per_s * t_s;
            return Pose2{3.0 * std::sin(way_m / 3.0), 0.5 * std::sin(way_m), 0.4 * std::sin(0.7 * way_m)};
        };
        for (int i = 0; 0.2 * i < seconds; ++i) {
            scans_.add(test::room_scan(robot(0.2 * i) * Pose2{0.2, 0.0, 1.5}, 0.2 * i, random, 360, room));
        }
        for (int i = 0; 0.05 * i < seconds; ++i) {
            const Pose2 pose = robot(0.05 * i);
            odometry_.add({std::llround(5e7 * i), {scale * pose.x_m, scale * pose.y_m, pose.theta_rad}});
        }
    }

    ScanWay scans_;
    WayTrack odometry_;
};

TEST_F(Way, IsMeasuredInAnyUnitAndAtAnySpeed) {
    for (const double scale : {0.001, 0.5, 1.0, 3.281, 100.0, 1000.0}) {
        for (const double speed_m_per_s : {0.02, 0.3, 1.5}) {
            drive(scale, speed_m_per_s);
            const auto found = way_scale(scans_, odometry_, 0.0);
            ASSERT_TRUE(found) << scale << " at " << speed_m_per_s;
            EXPECT_NEAR(*found / scale, 1.0, 0.15) << scale << " at " << speed_m_per_s;
        }
    }
}

TEST_F(Way, MetresAndPoorWheelsAreBelieved) {
    for (const double scale : {0.5, 0.8, 1.0, 1.25, 2.0}) {
        drive(scale);
        EXPECT_THAT(length_fault(scans_, odometry_, 0.0), IsEmpty()) << scale;
    }
}

TEST_F(Way, AnotherUnitIsNamed) {
    drive(1000.0);
    EXPECT_THAT(length_fault(scans_, odometry_, 0.0), HasSubstr("as if it were in millimetres; expected metres"));
    drive(100.0, 0.02);
    EXPECT_THAT(length_fault(scans_, odometry_, 0.0), HasSubstr("in centimetres"));
    drive(3.281);
    EXPECT_THAT(length_fault(scans_, odometry_, 0.0), HasSubstr("it moves 3.2"));
    drive(7.0);
    EXPECT_THAT(length_fault(scans_, odometry_, 0.0), HasSubstr("times as far as the scans show; expected metres"));
}

TEST_F(Way, WhereTheScansTellNothingTheSpeedIsJudged) {
    const test::Room corridor{.half_length_m = 1000.0, .half_width_m = 1.5};
    drive(1.0, 0.3, corridor);
    EXPECT_THAT(length_fault(scans_, odometry_, 0.0), IsEmpty());
    odometry_ = {};
    for (int i = 0; i < 1000; ++i) {
        odometry_.add({std::llround(5e7 * i), {30.0 * 0.05 * i, 0.0, 0.0}});
    }
    EXPECT_THAT(length_fault({}, odometry_, 0.0), HasSubstr("it drives at 30 m/s"));
}

TEST_F(Way, AJumpOfTheOdometryDoesNotHideItsUnit) {
    drive(100.0);
    WayTrack with_jump;
    for (int i = 0; i < 1200; ++i) {
        const double way_m = 0.3 * 0.05 * i;
        const double jump_m = i > 600 ? 5000.0 : 0.0;
        with_jump.add({std::llround(5e7 * i),
                       {300.0 * std::sin(way_m / 3.0) + jump_m, 50.0 * std::sin(way_m), 0.4 * std::sin(0.7 * way_m)}});
    }
    EXPECT_THAT(length_fault(scans_, with_jump, 0.0), HasSubstr("in centimetres"));
}

TEST_F(Way, OdometryOfAnotherRobotHasNoScale) {
    drive(1.0);
    WayTrack other;
    for (int i = 0; i < 1200; ++i) {
        other.add({std::llround(5e7 * i), {5.0 * std::sin(1.7 * std::sqrt(i)), 4.0 * std::cos(0.13 * i), 0.1 * i}});
    }
    EXPECT_FALSE(way_scale(scans_, other, 0.0));
    EXPECT_FALSE(way_scale({}, {}, 0.0));
}

}  // namespace
}  // namespace ddtool
