#include "ddtool/robot/pose2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

constexpr double tolerance = 1e-9;
using std::numbers::pi;

void expect_near(const Pose2& a, const Pose2& b) {
    EXPECT_NEAR(a.x_m, b.x_m, tolerance);
    EXPECT_NEAR(a.y_m, b.y_m, tolerance);
    EXPECT_NEAR(wrap_angle(a.theta_rad - b.theta_rad), 0.0, tolerance);
}

Pose2 random_pose(RandomStream& random) {
    const double x = random.uniform(-50.0, 50.0);
    const double y = random.uniform(-50.0, 50.0);
    return {x, y, random.uniform(-pi, pi)};
}

class Pose2Algebra : public testing::TestWithParam<std::uint64_t> {
protected:
    RandomStream random_{GetParam()};
    Pose2 a_ = random_pose(random_);
    Pose2 b_ = random_pose(random_);
    Pose2 c_ = random_pose(random_);
};

TEST_P(Pose2Algebra, IsAGroup) {
    expect_near(a_ * Pose2{}, a_);
    expect_near(Pose2{} * a_, a_);
    expect_near(a_ * inverse(a_), {});
    expect_near(inverse(a_) * a_, {});
    expect_near((a_ * b_) * c_, a_ * (b_ * c_));
    expect_near(inverse(a_ * b_), inverse(b_) * inverse(a_));
}

TEST_P(Pose2Algebra, ComposesAsItsPointsDo) {
    const Point2 point{b_.x_m, c_.y_m};
    const Point2 at_once = (a_ * b_) * point;
    const Point2 in_turn = a_ * (b_ * point);
    EXPECT_NEAR(at_once.x_m, in_turn.x_m, tolerance);
    EXPECT_NEAR(at_once.y_m, in_turn.y_m, tolerance);
}

TEST_P(Pose2Algebra, BetweenIsSeenFromTheFirstWhereverBothStand) {
    expect_near(a_ * between(a_, b_), b_);
    expect_near(between(c_ * a_, c_ * b_), between(a_, b_));
}

TEST_P(Pose2Algebra, DistanceKeepsUnderMotion) {
    EXPECT_NEAR(distance_m(c_ * a_, c_ * b_), distance_m(a_, b_), tolerance);
    EXPECT_EQ(distance_m(a_, b_), distance_m(b_, a_));
}

TEST_P(Pose2Algebra, InterpolatesFromEndToEnd) {
    expect_near(interpolate(a_, b_, 0.0), a_);
    expect_near(interpolate(a_, b_, 1.0), b_);
    expect_near(interpolate(a_, b_, 0.3), interpolate(b_, a_, 0.7));
    const Pose2 middle = interpolate(a_, b_, 0.5);
    EXPECT_LE(std::abs(wrap_angle(middle.theta_rad - a_.theta_rad)), pi / 2.0 + tolerance);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Pose2Algebra, testing::Range<std::uint64_t>(0, 20));

TEST(Pose2, TurnsCounterClockwise) {
    const Point2 point = Pose2{1.0, 2.0, pi / 2.0} * Point2{1.0, 0.0};
    EXPECT_NEAR(point.x_m, 1.0, tolerance);
    EXPECT_NEAR(point.y_m, 3.0, tolerance);
}

TEST(WrapAngle, IsTheSameAngleWithinHalfATurn) {
    for (double angle = -30.0; angle < 30.0; angle += 0.37) {
        const double wrapped = wrap_angle(angle);
        EXPECT_LE(std::abs(wrapped), pi);
        EXPECT_NEAR(std::cos(wrapped), std::cos(angle), tolerance);
        EXPECT_NEAR(std::sin(wrapped), std::sin(angle), tolerance);
    }
}

}  // namespace
}  // namespace ddtool
