#include "check/sight.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "box_scan.hpp"

namespace ddtool::check {
namespace {

using test::seen_from;

const Pose2 here{-1.0, -0.5, 0.3};
const Pose2 there{1.2, 0.6, -1.1};

TEST(Sight, ScansOfOneRoomAgreeWhereTheyWereTaken) {
    const Agreement found = agreement(Sight(seen_from(here)), Sight(seen_from(there)), between(here, there));
    EXPECT_GT(found.same, 150U);
    EXPECT_EQ(found.through, 0U);
}

TEST(Sight, ScansPlacedWronglyContradictEachOther) {
    const Pose2 wrong{there.x_m - 0.6, there.y_m, there.theta_rad};
    const Agreement found = agreement(Sight(seen_from(here)), Sight(seen_from(there)), between(here, wrong));
    EXPECT_GT(found.contradicted(), 0.1);
}

TEST(Sight, TheDirectionInWhichTheLidarTurnsDoesNotMatter) {
    SensorFrame clockwise = seen_from(there);
    std::reverse(clockwise.scan.ranges_m.begin(), clockwise.scan.ranges_m.end());
    clockwise.scan.angle_min_rad = clockwise.scan.angle_rad(359);
    clockwise.scan.angle_increment_rad *= -1.0;
    const Agreement found = agreement(Sight(seen_from(here)), Sight(clockwise), between(here, there));
    EXPECT_GT(found.same, 150U);
    EXPECT_EQ(found.through, 0U);
}

TEST(Sight, TheMountingIsTakenIntoAccount) {
    const Pose2 robot_from_laser{0.4, 0.1, 2.0};
    SensorFrame mounted = seen_from(there * robot_from_laser);
    mounted.robot_from_laser = robot_from_laser;
    const Agreement found = agreement(Sight(seen_from(here)), Sight(mounted), between(here, there));
    EXPECT_GT(found.same, 150U);
    EXPECT_EQ(found.through, 0U);
}

TEST(Sight, ABeamWithoutReturnContradictsNothing) {
    const Sight blind(seen_from(here, {}, 0.1));
    EXPECT_EQ(agreement(blind, Sight(seen_from(there)), between(here, there)).points(), 0U);
}

TEST(Sight, TheRobotItselfIsNoSurface) {
    SensorFrame first = seen_from(here);
    SensorFrame second = seen_from(there);
    for (std::size_t beam = 60; beam < 200; ++beam) {
        first.scan.ranges_m[beam] = second.scan.ranges_m[beam] = 0.4F;  // a mast
    }
    EXPECT_EQ(agreement(Sight(first), Sight(second), between(here, there)).through, 0U);
}

TEST(Sight, OneScanSeesThroughWhatIsNotThere) {
    const Sight sight(seen_from({}));
    EXPECT_EQ(sight.word_on({1.5, 0.2}, 0.15), Sight::Word::through);
    EXPECT_EQ(sight.word_on({2.95, 0.2}, 0.15), Sight::Word::same);
    EXPECT_EQ(sight.word_on({5.0, 0.2}, 0.15), Sight::Word::nothing);  // behind the wall
    EXPECT_EQ(sight.word_on({0.1, 0.0}, 0.15), Sight::Word::nothing);  // at the lidar itself
}

TEST(Sight, OddScansAreNoTrouble) {
    SensorFrame empty;
    const Sight nothing(empty);
    EXPECT_EQ(agreement(nothing, Sight(seen_from(here)), {}).points(), 0U);
    SensorFrame one = seen_from(here);
    one.scan.ranges_m.resize(1);
    one.scan.angle_increment_rad = 0.0;
    EXPECT_EQ(Sight(one).word_on({1.0, 0.0}, 0.1), Sight::Word::nothing);
    SensorFrame many = seen_from(here);
    many.scan.ranges_m.resize(5000, 1.0F);
    EXPECT_LE(Sight(many).beams(), Sight::most_beams);
}

}  // namespace
}  // namespace ddtool::check
