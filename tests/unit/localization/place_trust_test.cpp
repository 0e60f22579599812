#include "localization/place_trust.hpp"

#include <gtest/gtest.h>

namespace ddtool::localization {
namespace {

TEST(PlaceTrust, BeginsWithTheFirstSurePose) {
    PlaceTrust trust;
    trust.add(0.7, 0.3);
    EXPECT_EQ(trust.state(), PlaceState::searching);
    trust.add(0.1, 0.9);
    EXPECT_EQ(trust.state(), PlaceState::searching) << "who was not found yet is not lost";
    trust.add(0.95, 0.02);
    EXPECT_EQ(trust.state(), PlaceState::found);
}

TEST(PlaceTrust, StaysWhileThePoseIsMoreProbablyRightThanWrong) {
    PlaceTrust trust;
    trust.told();
    trust.add(0.6, 0.35);
    EXPECT_EQ(trust.state(), PlaceState::found);
}

TEST(PlaceTrust, EndsWhereTheRobotIsLostOrSeveralPlacesFit) {
    PlaceTrust trust;
    trust.told();
    trust.add(0.3, 0.6);
    EXPECT_EQ(trust.state(), PlaceState::lost);
    trust.add(0.4, 0.1);
    EXPECT_EQ(trust.state(), PlaceState::ambiguous);
    trust.add(0.8, 0.1);
    EXPECT_EQ(trust.state(), PlaceState::ambiguous) << "it comes back only when it is sure";
    trust.add(0.9, 0.05);
    EXPECT_EQ(trust.state(), PlaceState::found);
}

}  // namespace
}  // namespace ddtool::localization
