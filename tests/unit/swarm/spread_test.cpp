#include "swarm/spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "swarms.hpp"

namespace ddtool {
namespace {

constexpr Pose2 SnapshotParticle::*predicted = &SnapshotParticle::predicted_motion;

std::vector<SnapshotParticle> turned_predictions(std::vector<SnapshotParticle> particles, double turn_rad) {
    for (SnapshotParticle& particle : particles) {
        particle.predicted_motion = Pose2{20.0, -30.0, turn_rad} * particle.predicted_motion;
    }
    return particles;
}

TEST(Spread, IsThatOfTheMajorAxisInAnyDirection) {
    constexpr std::size_t count = 20'000;
    const std::vector<SnapshotParticle> swarm = test::normal_swarm(count, 6, {}, 0.1);
    const double whole_m = spread_m(swarm, predicted);
    EXPECT_NEAR(whole_m, 0.1, 5.0 * 0.1 / std::sqrt(2.0 * count)) << "five standard errors";
    for (const double turn_rad : {0.7, 1.6, -2.9}) {
        EXPECT_NEAR(spread_m(turned_predictions(swarm, turn_rad), predicted), whole_m, 1e-9);
    }
}

TEST(Spread, IsZeroWhereNothingSpreads) {
    EXPECT_EQ(spread_m({}, predicted), 0.0);
    EXPECT_EQ(spread_m(test::normal_swarm(1, 1, {}), predicted), 0.0);
    EXPECT_EQ(spread_m(std::vector<SnapshotParticle>(30), predicted), 0.0);
}

TEST(Spread, LooksAtThePositionAskedForAndAtFiniteOnes) {
    std::vector<SnapshotParticle> swarm(3);
    swarm[0].pose.x_m = -1.0;
    swarm[1].pose.x_m = 1.0;
    swarm[2].pose.x_m = std::numeric_limits<double>::infinity();
    swarm[1].matched_motion.y_m = 3.0;
    EXPECT_DOUBLE_EQ(spread_m(swarm, &SnapshotParticle::pose), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(spread_m(swarm, &SnapshotParticle::matched_motion), std::sqrt(3.0));
    EXPECT_EQ(spread_m(swarm, predicted), 0.0);
}

TEST(WeightedSpread, CountsAParticleOfTwiceTheWeightAsTwo) {
    std::vector<SnapshotParticle> swarm = test::normal_swarm(20, 3, {0.3, 0.1});
    std::vector<SnapshotParticle> doubled = swarm;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
        swarm[i].weight = i == 0 ? 2.0 / 21.0 : 1.0 / 21.0;
    }
    doubled.push_back(doubled.front());
    // The same sums over other degrees of freedom: 1 - sum w^2 against (n - 1) / n.
    const double freedom = 1.0 - (4.0 + 19.0) / (21.0 * 21.0);
    const PositionSpread weighted = weighted_position_spread(swarm, &SnapshotParticle::pose);
    const PositionSpread plain = position_spread(doubled, &SnapshotParticle::pose);
    EXPECT_NEAR(weighted.major_m, plain.major_m * std::sqrt(20.0 / 21.0 / freedom), 1e-12);
    EXPECT_NEAR(weighted.minor_m, plain.minor_m * std::sqrt(20.0 / 21.0 / freedom), 1e-12);
    EXPECT_LT(plain.minor_m, plain.major_m);
}

TEST(WeightedSpread, IsZeroWhereOneParticleHasAllTheWeight) {
    std::vector<SnapshotParticle> swarm = test::normal_swarm(20, 3, {0.3, 0.1});
    swarm[4].weight = 1.0;
    EXPECT_EQ(weighted_position_spread(swarm, &SnapshotParticle::pose).major_m, 0.0);
}

TEST(StepSpreadRatio, IsOneWhereTheScanLeavesAllOpen) {
    std::vector<SnapshotParticle> swarm = test::normal_swarm(20, 3, {});
    EXPECT_EQ(step_spread_ratio(std::vector<SnapshotParticle>(3)), 0.0);
    for (SnapshotParticle& particle : swarm) {
        particle.matched_motion = particle.predicted_motion;
    }
    EXPECT_DOUBLE_EQ(step_spread_ratio(swarm), 1.0);
}

}  // namespace
}  // namespace ddtool
