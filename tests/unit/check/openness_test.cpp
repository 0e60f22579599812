#include "check/openness.hpp"

#include <gtest/gtest.h>

#include "box_scan.hpp"

namespace ddtool::check {
namespace {

using test::Box;
using test::seen_from;

const Box corridor{.half_length_m = 50.0, .half_width_m = 1.0};

TEST(Openness, ACorridorLeavesTheWayAlongItOpen) {
    for (const double heading : {0.0, 0.2, 1.0, 3.0}) {
        const Pose2 pose{0.0, 0.2, heading};
        const Pose2 along = between(pose, {0.3, 0.2, heading});
        const Pose2 across = between(pose, {0.0, 0.5, heading});
        EXPECT_EQ(openness_of(Sight(seen_from(pose, corridor, 8.0)), along), Openness::walls) << heading;
        EXPECT_EQ(openness_of(Sight(seen_from(pose, corridor, 8.0)), across), Openness::held) << heading;
    }
}

TEST(Openness, ARoomHoldsTheRobot) { EXPECT_EQ(openness_of(Sight(seen_from({})), {0.3, 0.0, 0.0}), Openness::held); }

TEST(Openness, OpenGroundHoldsNothing) {
    const Box wide{.half_length_m = 50.0, .half_width_m = 50.0};
    EXPECT_EQ(openness_of(Sight(seen_from({}, wide, 5.0)), {0.3, 0.0, 0.0}), Openness::blind);
}

}  // namespace
}  // namespace ddtool::check
