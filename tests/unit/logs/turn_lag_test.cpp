#include "logs/stream/turn_lag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ddtool/base/random.hpp"
#include "ddtool/robot/pose2.hpp"
#include "logs/stream/scan_turn.hpp"
#include "room_scan.hpp"

namespace ddtool {
namespace {

TEST(ScanTurn, IsFoundWhileTheRobotDrives) {
    RandomStream random({1});
    for (const int beams : {100, 360, 1080}) {
        const LaserScan before = test::room_scan({0.5, -0.3, 0.4}, 0.0, random, beams);
        for (const double turn_rad : {-0.5, -0.05, 0.0, 0.02, 0.3}) {
            const Pose2 after = Pose2{0.5, -0.3, 0.4} * Pose2{0.12, 0.03, turn_rad};
            EXPECT_NEAR(turn_between(before, test::room_scan(after, 0.2, random, beams)).value(), turn_rad, 0.006)
                << beams;
        }
    }
}

TEST(ScanTurn, IsNotMadeUp) {
    RandomStream random({1});
    const LaserScan scan = test::room_scan({}, 0.0, random);
    EXPECT_FALSE(turn_between(scan, test::room_scan({}, 0.0, random, 180)));
    LaserScan empty = scan;
    empty.ranges_m.assign(scan.ranges_m.size(), LaserScan::no_return);
    EXPECT_FALSE(turn_between(scan, empty));
    EXPECT_FALSE(turn_between(LaserScan{}, LaserScan{}));
}

/// A drive of `seconds` that turns to and fro, with scans at 5 Hz and odometry at 20 Hz.
class Turns : public testing::Test {
protected:
    static double heading(double t_s) { return 0.9 * std::sin(0.9 * t_s) + 0.3 * std::sin(2.1 * t_s); }
    void drive(double seconds, double late_s, double scale = 1.0, double sweep_s = 0.0) {
        RandomStream random({7});
        scans_ = {};
        odometry_ = {};
        for (int i = 0; 0.2 * i < seconds; ++i) {
            const double t_s = 0.2 * i;
            LaserScan scan = test::room_scan({std::sin(0.2 * t_s), 0.0, heading(t_s + sweep_s / 2.0)}, t_s, random);
            scan.time_increment_s = sweep_s / 360.0;
            scans_.add(scan);
        }
        for (int i = 0; 0.05 * i < seconds; ++i) {
            const double t_s = 0.05 * i;
            odometry_.add(std::llround(1e9 * (t_s + late_s)), scale * heading(t_s) + 0.001 * random.normal());
        }
    }

    ScanTurns scans_;
    HeadingTrack odometry_;
};

TEST_F(Turns, TheLagIsMeasuredWithinItsUncertainty) {
    for (const double late_s : {-0.15, -0.04, 0.03, 0.1, 0.3}) {
        drive(30.0, late_s);
        const TurnLag lag = turn_lag(scans_, odometry_, 0.0).value();
        EXPECT_NEAR(lag.late_s, late_s, 4.0 * lag.sigma_s);
        EXPECT_LT(lag.sigma_s, 0.006);
        EXPECT_TRUE(lag.is_significant()) << late_s;
    }
}

TEST_F(Turns, StampsThatAgreeHaveNone) {
    drive(30.0, 0.0);
    EXPECT_FALSE(turn_lag(scans_, odometry_, 0.0).value().is_significant());
}

TEST_F(Turns, WheelsThatTurnTooFarAndALidarUpsideDownDoNotMatter) {
    for (const double scale : {1.1, -0.95}) {
        drive(30.0, 0.1, scale);
        const TurnLag lag = turn_lag(scans_, odometry_, 0.0).value();
        EXPECT_NEAR(lag.late_s, 0.1, 4.0 * lag.sigma_s);
        EXPECT_NEAR(lag.scale, 1.0 / scale, 0.03);
    }
}

TEST_F(Turns, AScanIsOfTheMiddleOfItsSweep) {
    drive(30.0, 0.0, 1.0, 0.1);
    const TurnLag lag = turn_lag(scans_, odometry_, 0.0).value();
    EXPECT_NEAR(lag.late_s, 0.05, 4.0 * lag.sigma_s);
}

TEST_F(Turns, ClocksThatAreFarApartAreBroughtTogetherFirst) {
    drive(30.0, 100.05);
    EXPECT_FALSE(turn_lag(scans_, odometry_, 0.0));
    EXPECT_NEAR(turn_lag(scans_, odometry_, 100.0).value().late_s, 0.05, 0.02);
}

TEST_F(Turns, TooFewTurnsTellNothing) {
    drive(2.0, 0.1);
    EXPECT_FALSE(turn_lag(scans_, odometry_, 0.0));
    EXPECT_FALSE(turn_lag({}, {}, 0.0));
}

TEST_F(Turns, OdometryOfAnotherRobotTellsNothing) {
    drive(30.0, 0.0);
    HeadingTrack other;
    for (int i = 0; i < 600; ++i) {
        other.add(std::llround(5e7 * i), std::sin(1.7 * std::sqrt(i)));
    }
    EXPECT_FALSE(turn_lag(scans_, other, 0.0));
}

}  // namespace
}  // namespace ddtool
