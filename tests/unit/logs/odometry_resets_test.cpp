#include "logs/stream/odometry_resets.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool {
namespace {

/// A robot that drives a circle at 0.5 m/s, with odometry at 20 Hz.
class Resets : public testing::Test {
protected:
    Pose2 drive(int steps) {
        Pose2 pose;
        for (int i = 0; i < steps; ++i) {
            logged_ = logged_ * Pose2{0.025, 0.0, 0.025};
            true_ = true_ * Pose2{0.025, 0.0, 0.025};
            pose = at(logged_, 0.05);
        }
        return pose;
    }
    /// The next step, before which the source starts again at another pose.
    Pose2 drive_after_reset(const Pose2& logged) {
        true_ = true_ * Pose2{0.025, 0.0, 0.025};
        return at(logged, 0.05);
    }
    Pose2 at(const Pose2& logged, double elapsed_s) {
        stamp_ns_ += std::llround(1e9 * elapsed_s);
        logged_ = logged;
        return resets_.follow({stamp_ns_, logged});
    }
    void expect_true(const Pose2& pose) {
        EXPECT_NEAR(distance_m(pose, true_), 0.0, 1e-4) << "chords of the same arc";
        EXPECT_NEAR(wrap_angle(pose.theta_rad - true_.theta_rad), 0.0, 1e-9);
    }

    OdometryResets resets_;
    Pose2 logged_{3.0, 1.0, 0.5};
    Pose2 true_ = logged_;
    std::int64_t stamp_ns_ = 0;
};

TEST_F(Resets, WhatIsContinuousStaysAsItIsToTheLastBit) {
    logged_ = {3.0, 1.0, 4.5};
    for (int i = 0; i < 100; ++i) {
        logged_.theta_rad += 0.1;
        const Pose2 pose = at(logged_, 0.1);
        EXPECT_EQ(pose, logged_);
        EXPECT_FALSE(resets_.last_jump());
    }
}

TEST_F(Resets, AcrossAStartFromZeroTheRobotGoesOnAsBefore) {
    expect_true(drive(100));
    const Pose2 after = drive_after_reset({});
    expect_true(after);
    ASSERT_TRUE(resets_.last_jump());
    EXPECT_TRUE(resets_.last_jump()->to_origin);
    EXPECT_TRUE(resets_.last_jump()->is_bridged);
    EXPECT_NE(OdometryResets::text(*resets_.last_jump()).find("to its origin"), std::string::npos);
    expect_true(drive(50));
    EXPECT_FALSE(resets_.last_jump());
}

TEST_F(Resets, AcrossAPauseTheMotionIsUnknown) {
    drive(100);
    expect_true(at({}, 20.0));
    ASSERT_TRUE(resets_.last_jump());
    EXPECT_FALSE(resets_.last_jump()->is_bridged);
}

TEST_F(Resets, SeveralInARowAndToAnyPoseAreTakenOut) {
    drive(100);
    for (const Pose2& pose : {Pose2{}, Pose2{7.3, -2.1, 2.2}, Pose2{-40.0, 3.0, -1.0}, Pose2{}}) {
        expect_true(drive_after_reset(pose));
        EXPECT_TRUE(resets_.last_jump());
        expect_true(drive(30));
    }
}

TEST_F(Resets, AJumpElsewhereAndATurnOnTheSpotAreNone) {
    drive(100);
    for (const Pose2& jump :
         {Pose2{1.0, -2.0, 0.1}, Pose2{1.0, 0.0, 0.0}, Pose2{0.0, 0.0, 1.5}, Pose2{0.0, 0.0, 0.35}}) {
        expect_true(drive_after_reset(logged_ * jump));
        EXPECT_TRUE(resets_.last_jump());
        expect_true(drive(10));
    }
}

TEST_F(Resets, APauseInTheMessagesIsNoJump) {
    drive(100);
    const Pose2 later = logged_ * Pose2{5.0, 0.0, 1.0};
    EXPECT_EQ(at(later, 10.0), later);
    EXPECT_FALSE(resets_.last_jump());
}

TEST_F(Resets, AJumpDuringAPauseIsOne) {
    drive(100);
    expect_true(at(logged_ * Pose2{6.0, 0.0, 0.0}, 3.0));
    EXPECT_TRUE(resets_.last_jump());
}

TEST_F(Resets, ARobotThatStartsToDriveIsBelieved) {
    for (int i = 0; i < 50; ++i) {
        at(logged_, 0.5);
    }
    const Pose2 driving = logged_ * Pose2{0.5, 0.0, 0.0};
    EXPECT_EQ(at(driving, 0.5), driving);
    EXPECT_FALSE(resets_.last_jump());
}

TEST_F(Resets, StampsThatStandStillMakeNoJump) {
    drive(100);
    const Pose2 next = logged_ * Pose2{0.1, 0.0, 0.0};
    EXPECT_EQ(at(next, 0.0), next);
}

}  // namespace
}  // namespace ddtool
