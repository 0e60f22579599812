#include "merging/wall_agreement.hpp"

#include <gtest/gtest.h>

#include "driven_maps.hpp"
#include "merging/map_side.hpp"

namespace ddtool::merging {
namespace {

TEST(WallAgreement, CountsBothWays) {
    const maps::SavedMap map = test::map_of(test::two_rooms(), 1, {}, test::anywhere);
    const auto side = side_of(map.nodes, comparing(map.grid.settings()));
    const auto window = side->local_map(0);
    const WallAgreement right = wall_agreement(*window, map.grid, side->anchor(0));
    EXPECT_GT(right.known, window->points.size());  // the map's own walls count, too
    EXPECT_GT(right.share(), 0.97);
    const Pose2 moved = side->anchor(0) * Pose2{0.5, 0.4, 0.0};
    const WallAgreement wrong = wall_agreement(*window, map.grid, moved);
    EXPECT_LT(wrong.share(), 0.6);
    EXPECT_GT(wrong.contradicted(), right.contradicted() + 50);
}

TEST(WallAgreement, WhatTheOtherDoesNotShowDoesNotCount) {
    const maps::SavedMap map = test::map_of(test::two_rooms(), 1, {}, test::anywhere);
    const auto side = side_of(map.nodes, comparing(map.grid.settings()));
    const WallAgreement apart = wall_agreement(*side->local_map(0), map.grid, Pose2{100.0, 0.0, 0.0});
    EXPECT_EQ(apart.known, 0U);
    EXPECT_EQ(apart.share(), 0.0);
}

}  // namespace
}  // namespace ddtool::merging
