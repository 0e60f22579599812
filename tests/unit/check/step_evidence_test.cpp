#include "check/step_evidence.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "box_scan.hpp"

namespace ddtool::check {
namespace {

StepEvidence evidence_of_drive(const std::vector<std::pair<double, double>>& time_and_place) {
    StepWitness witness;
    for (const auto& [time_s, x_m] : time_and_place) {
        SensorFrame frame;
        frame.scan.stamp_ns = std::llround(1e9 * time_s);
        frame.odom_from_robot = {x_m, 0.0, 0.0};
        witness.add(frame);
    }
    return witness.evidence();
}

TEST(StepEvidence, AnOdometryThatIsHeldGoesInStairs) {
    std::vector<std::pair<double, double>> steps;
    for (int scan = 0; scan < 50; ++scan) {
        steps.emplace_back(0.2 * scan, std::floor(0.2 * scan));  // 1 m/s, but in whole seconds
    }
    const StepEvidence evidence = evidence_of_drive(steps);
    EXPECT_EQ(evidence.moving, 9U);
    EXPECT_EQ(evidence.stairs, 9U);
}

TEST(StepEvidence, ARobotThatStopsAndScansGoesInNone) {
    std::vector<std::pair<double, double>> steps;
    for (int stop = 0; stop < 10; ++stop) {
        for (int scan = 0; scan < 5; ++scan) {
            steps.emplace_back(3.0 * stop + 0.2 * scan, 1.0 * stop);  // drives 1 m in 2 s without scanning
        }
    }
    const StepEvidence evidence = evidence_of_drive(steps);
    EXPECT_EQ(evidence.moving, 9U);
    EXPECT_EQ(evidence.stairs, 0U);
    EXPECT_EQ(evidence.lost, 0U);
}

TEST(StepEvidence, MotionIsLostInAPauseInMidDrive) {
    const std::vector<std::pair<double, double>> lost{{0.0, 0.0}, {0.2, 0.2}, {10.2, 0.2}, {10.4, 0.4}};
    EXPECT_EQ(evidence_of_drive(lost).lost, 1U);
    EXPECT_NEAR(evidence_of_drive(lost).longest_lost_s, 10.0, 1e-6);
    const std::vector<std::pair<double, double>> driven_on{{0.0, 0.0}, {0.2, 0.2}, {10.2, 9.0}, {10.4, 9.2}};
    EXPECT_EQ(evidence_of_drive(driven_on).lost, 0U);
    const std::vector<std::pair<double, double>> stood{{0.0, 0.0}, {0.2, 0.0}, {10.2, 0.0}, {10.4, 0.1}};
    EXPECT_EQ(evidence_of_drive(stood).lost, 0U);
}

TEST(StepEvidence, NoMotionIsLostWhereTheScansBeforeAndAfterThePauseAgree) {
    const auto lost_with = [](double truth_after_m) {
        StepWitness witness;
        const std::vector<std::array<double, 3>> time_truth_odometry{
            {0.0, 0.0, 0.0}, {0.2, 0.2, 0.2}, {10.2, truth_after_m, 0.2}, {10.4, truth_after_m + 0.2, 0.4}};
        for (const auto& [time_s, truth_m, odometry_m] : time_truth_odometry) {
            SensorFrame frame = test::seen_from({truth_m, 0.0, 0.0});
            frame.scan.stamp_ns = std::llround(1e9 * time_s);
            frame.odom_from_robot = {odometry_m, 0.0, 0.0};
            witness.add(frame);
        }
        return witness.evidence().lost;
    };
    EXPECT_EQ(lost_with(0.2), 0U) << "the recorder left out a robot at rest";
    EXPECT_EQ(lost_with(2.0), 1U);
}

TEST(StepEvidence, InACorridorOnlyTheSpeedsBesideThePauseTellWhetherTheRobotStood) {
    const auto lost_with = [](double last_step_m) {
        StepWitness witness;
        const double stop_m = 0.4 + last_step_m;
        const std::vector<std::pair<double, double>> time_and_place{
            {0.0, 0.0},     {0.2, 0.2},           {0.4, 0.4},          {0.6, stop_m},
            {10.6, stop_m}, {10.8, stop_m + 0.2}, {11.0, stop_m + 0.4}};
        for (const auto& [time_s, x_m] : time_and_place) {
            SensorFrame frame = test::seen_from({x_m, 0.0, 0.0}, {.half_length_m = 50.0}, 8.0);
            frame.scan.stamp_ns = std::llround(1e9 * time_s);
            witness.add(frame);
        }
        return witness.evidence().lost;
    };
    EXPECT_EQ(lost_with(0.2), 1U) << "at full speed before and after";
    EXPECT_EQ(lost_with(0.04), 0U) << "it braked";
}

TEST(StepEvidence, StampsThatStandStillOrStepBackAreLeftOut) {
    const StepEvidence evidence = evidence_of_drive({{0.0, 0.0}, {0.0, 1.0}, {-5.0, 2.0}, {-4.9, 2.1}});
    EXPECT_EQ(evidence.moving, 1U);
    EXPECT_EQ(evidence.stairs + evidence.lost, 0U);
}

}  // namespace
}  // namespace ddtool::check
