#include "logs/stream/odometry_gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool {
namespace {

std::int64_t ns(double seconds) { return std::llround(1e9 * seconds); }

TEST(OdometryGaps, APauseInWhichTheRobotMovedIsAGuess) {
    OdometryGaps gaps(0.05);
    EXPECT_FALSE(gaps.add({ns(1.0), {}}));
    EXPECT_FALSE(gaps.add({ns(1.05), {0.1, 0.0, 0.0}}));
    const auto gap = gaps.add({ns(3.0), {0.5, 0.0, 0.0}});
    ASSERT_TRUE(gap);
    EXPECT_EQ(gap->from_ns, ns(1.05));
    EXPECT_EQ(gaps.step(ns(0.9), ns(1.05)), OdometryStep::measured);
    for (const auto& [from_s, to_s] : {std::pair{1.0, 1.1}, {1.5, 1.7}, {2.9, 3.1}, {0.0, 9.0}, {3.1, 2.9}}) {
        EXPECT_EQ(gaps.step(ns(from_s), ns(to_s)), OdometryStep::guessed) << from_s;
    }
    EXPECT_EQ(gaps.step(ns(3.0), ns(3.2)), OdometryStep::measured);
}

TEST(OdometryGaps, APauseOfARobotThatStandsIsNone) {
    OdometryGaps gaps(0.05);
    gaps.add({ns(1.0), {2.0, 0.0, 0.0}});
    EXPECT_FALSE(gaps.add({ns(9.0), {2.01, 0.0, 0.01}}));
    EXPECT_EQ(gaps.step(ns(2.0), ns(3.0)), OdometryStep::measured);
}

TEST(OdometryGaps, SlowOdometryHasLongIntervals) {
    OdometryGaps gaps(0.4);
    gaps.add({ns(1.0), {}});
    EXPECT_FALSE(gaps.add({ns(2.5), {1.0, 0.0, 0.0}}));
    EXPECT_TRUE(gaps.add({ns(4.6), {2.0, 0.0, 0.0}}));
}

TEST(OdometryGaps, TheUnknownIsWorseThanAGuess) {
    OdometryGaps gaps(0.05);
    gaps.add({ns(1.0), {}});
    gaps.add({ns(3.0), {1.0, 0.0, 0.0}});
    gaps.add_unknown(ns(3.0), ns(3.2));
    EXPECT_EQ(gaps.step(ns(2.9), ns(3.1)), OdometryStep::unknown);
    EXPECT_EQ(gaps.step(ns(2.0), ns(2.9)), OdometryStep::guessed);
}

}  // namespace
}  // namespace ddtool
