#include "localization/lost_watch.hpp"

#include <gtest/gtest.h>

namespace ddtool::localization {
namespace {

/// The way until the probability passes `limit` when every scan has this support, or 20 m.
double way_until(LostWatch& watch, double support, double limit, bool above) {
    double way_m = 0.0;
    while (way_m < 20.0 && (watch.probability() > limit) != above) {
        watch.add(support, 0.1);
        way_m += 0.1;
    }
    return way_m;
}

TEST(LostWatch, AScanThatFitsFindsTheRobot) {
    LostWatch watch(0.5);
    EXPECT_LT(way_until(watch, 0.95, 0.1, false), 1.0);
}

TEST(LostWatch, AScanThatFitsNowhereTellsThatItIsLost) {
    LostWatch watch(0.1);
    way_until(watch, 0.95, 0.01, false);
    EXPECT_LT(way_until(watch, 0.5, 0.5, true), 2.0);
    EXPECT_LT(way_until(watch, 0.95, 0.1, false), 2.0);
}

TEST(LostWatch, WhatHidesTheWallsForAMomentIsNoProof) {
    LostWatch watch(0.1);
    way_until(watch, 0.95, 0.01, false);
    watch.add(0.3, 0.1);
    EXPECT_LT(watch.probability(), 0.1);
}

/// A map that was made before the furniture was moved explains less everywhere.
TEST(LostWatch, AChangedPlaceIsNotBeingLost) {
    LostWatch watch(0.1);
    double worst = 0.0;
    for (double support = 0.95; support > 0.75; support -= 0.001) {
        watch.add(support, 0.1);
        worst = std::max(worst, watch.probability());
    }
    for (int i = 0; i < 300; ++i) {
        watch.add(0.75, 0.1);
        worst = std::max(worst, watch.probability());
    }
    EXPECT_LT(worst, 0.3);
}

TEST(LostWatch, StandingStillProvesNothing) {
    LostWatch watch(0.4);
    for (int i = 0; i < 100; ++i) {
        watch.add(0.2, 0.0);
    }
    EXPECT_NEAR(watch.probability(), 0.4, 1e-9);
}

}  // namespace
}  // namespace ddtool::localization
