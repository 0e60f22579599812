#include "scores/association.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace ddtool {
namespace {

using testing::Optional;

constexpr std::int64_t ms = 1'000'000;

/// Poses at the given times in milliseconds; x is the number of the pose.
Trajectory poses_at_ms(const std::vector<std::int64_t>& stamps_ms) {
    Trajectory trajectory;
    for (const std::int64_t stamp : stamps_ms) {
        trajectory.push_back({stamp * ms, {static_cast<double>(trajectory.size()), 0.0, 0.0}});
    }
    return trajectory;
}

TEST(StampIndex, TakesTheNearestWithinTheTolerance) {
    const StampIndex index(poses_at_ms({0, 100, 200}));
    EXPECT_THAT(index.nearest(104 * ms, 0.01), Optional(1U));
    EXPECT_THAT(index.nearest(96 * ms, 0.01), Optional(1U));
    EXPECT_EQ(index.nearest(111 * ms, 0.01), std::nullopt);
    EXPECT_EQ(index.nearest(-11 * ms, 0.01), std::nullopt);
    EXPECT_THAT(index.nearest(205 * ms, 0.01), Optional(2U));
    EXPECT_THAT(index.nearest(50 * ms, 1.0), Optional(0U)) << "of two equally near the earlier";
}

TEST(StampIndex, FindsExactStampsWithNoTolerance) {
    const StampIndex index(poses_at_ms({0, 100}));
    EXPECT_THAT(index.nearest(100 * ms, 0.0), Optional(1U));
    EXPECT_EQ(index.nearest(100 * ms + 1, 0.0), std::nullopt);
}

TEST(StampIndex, LooksUpStampsThatStepBackwards) {
    const StampIndex index(poses_at_ms({300, 100, 200, 100}));
    EXPECT_THAT(index.nearest(301 * ms, 0.01), Optional(0U));
    EXPECT_THAT(index.nearest(100 * ms, 0.01), Optional(1U)) << "of equal stamps the first in the trajectory";
    EXPECT_THAT(index.nearest(99 * ms, 0.01), Optional(1U));
    EXPECT_THAT(index.nearest(102 * ms, 0.01), Optional(1U));
}

TEST(StampIndex, OfNothingFindsNothing) { EXPECT_EQ(StampIndex({}).nearest(0, 1e9), std::nullopt); }

TEST(StampIndex, SurvivesStampsAtBothEndsOfTime) {
    const StampIndex index(Trajectory{{std::numeric_limits<std::int64_t>::min(), {}}});
    EXPECT_EQ(index.nearest(std::numeric_limits<std::int64_t>::max(), 1.0), std::nullopt);
}

TEST(Associate, WalksTheShorterTrajectory) {
    const Trajectory dense = poses_at_ms({0, 50, 100, 150, 200});
    const Trajectory sparse = poses_at_ms({1, 102, 195, 900});
    const std::vector<PosePair> pairs = associate(dense, sparse, 0.01);
    ASSERT_EQ(pairs.size(), 3U);
    EXPECT_EQ(pairs[1].stamp_ns, 100 * ms) << "the stamp is the estimate's";
    EXPECT_EQ(pairs[2].estimate.x_m, 4.0);
    EXPECT_EQ(pairs[2].reference.x_m, 2.0);
}

TEST(Associate, SwappedGivesTheSamePairsSwapped) {
    const Trajectory dense = poses_at_ms({0, 50, 100, 150, 200});
    const Trajectory sparse = poses_at_ms({1, 102, 195});
    const std::vector<PosePair> there = associate(dense, sparse, 0.01);
    const std::vector<PosePair> back = associate(sparse, dense, 0.01);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_EQ(there[i].estimate, back[i].reference);
        EXPECT_EQ(there[i].reference, back[i].estimate);
    }
}

TEST(Associate, KeepsTheOrderOfTheFile) {
    const Trajectory jittering = poses_at_ms({0, 200, 100, 300});
    const std::vector<PosePair> pairs = associate(jittering, poses_at_ms({0, 100, 200, 300}), 0.01);
    ASSERT_EQ(pairs.size(), 4U);
    EXPECT_EQ(pairs[1].stamp_ns, 200 * ms);
    EXPECT_EQ(pairs[1].reference.x_m, 2.0);
}

}  // namespace
}  // namespace ddtool
