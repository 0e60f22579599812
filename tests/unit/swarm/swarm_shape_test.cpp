#include "ddtool/swarm/swarm_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "swarms.hpp"

namespace ddtool {
namespace {

std::vector<SnapshotParticle> with_equal_weights(std::vector<SnapshotParticle> particles) {
    for (SnapshotParticle& particle : particles) {
        particle.weight = 1.0 / static_cast<double>(particles.size());
    }
    return particles;
}

TEST(SwarmShape, OfManyDrawsIsThatOfTheDistribution) {
    const auto particles = with_equal_weights(test::normal_swarm(4000, 1, {0.5, 0.1}));
    const SwarmShape shape = swarm_shape(particles, &SnapshotParticle::pose);
    EXPECT_NEAR(std::sqrt(shape.major_variance_m2), 0.5, 0.02);
    EXPECT_NEAR(std::sqrt(shape.minor_variance_m2), 0.1, 0.005);
    EXPECT_NEAR(shape.major_direction_rad, 0.0, 0.02);
}

TEST(SwarmShape, TurnsWithTheSwarm) {
    auto particles = with_equal_weights(test::normal_swarm(50, 2, {0.5, 0.1}));
    const SwarmShape before = swarm_shape(particles, &SnapshotParticle::pose);
    for (SnapshotParticle& particle : particles) {
        particle.pose = Pose2{3.0, -7.0, 0.4} * particle.pose;
    }
    const SwarmShape after = swarm_shape(particles, &SnapshotParticle::pose);
    EXPECT_NEAR(after.major_variance_m2, before.major_variance_m2, 1e-9);
    EXPECT_NEAR(after.minor_variance_m2, before.minor_variance_m2, 1e-9);
    EXPECT_NEAR(after.major_direction_rad, before.major_direction_rad + 0.4, 1e-9);
}

TEST(SwarmShape, CountsAParticleOfTwiceTheWeightAsTwo) {
    std::vector<SnapshotParticle> swarm = test::normal_swarm(20, 3, {0.3, 0.1});
    std::vector<SnapshotParticle> doubled = swarm;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
        swarm[i].weight = i == 0 ? 2.0 / 21.0 : 1.0 / 21.0;
    }
    doubled.push_back(doubled.front());
    // The sums are the same, but they are divided by 1 - sum w^2 in one case and by (n - 1) / n in the other.
    const double freedom = 1.0 - (4.0 + 19.0) / (21.0 * 21.0);
    const SwarmShape weighted = swarm_shape(swarm, &SnapshotParticle::pose);
    const SwarmShape plain = unweighted_swarm_shape(doubled, &SnapshotParticle::pose);
    EXPECT_NEAR(weighted.major_sd_m(), plain.major_sd_m() * std::sqrt(20.0 / 21.0 / freedom), 1e-12);
    EXPECT_NEAR(weighted.minor_sd_m(), plain.minor_sd_m() * std::sqrt(20.0 / 21.0 / freedom), 1e-12);
    EXPECT_NEAR(weighted.major_direction_rad, plain.major_direction_rad, 1e-12);
    EXPECT_LT(plain.minor_sd_m(), plain.major_sd_m());
}

TEST(SwarmShape, IsAPointWhereOneParticleHasAllTheWeight) {
    std::vector<SnapshotParticle> swarm = test::normal_swarm(20, 3, {0.3, 0.1});
    swarm[4].weight = 1.0;
    EXPECT_EQ(swarm_shape(swarm, &SnapshotParticle::pose).major_variance_m2, 0.0);
    swarm[5].weight = 1e-12;  // so small that the rounding of the weights would be noticed
    EXPECT_EQ(swarm_shape(swarm, &SnapshotParticle::pose).major_variance_m2, 0.0);
}

TEST(SwarmShape, OfOneParticleIsAPoint) {
    const auto one = with_equal_weights(test::swarm_at({{4, 5}}));
    EXPECT_EQ(swarm_shape(one, &SnapshotParticle::pose).major_variance_m2, 0.0);
}

}  // namespace
}  // namespace ddtool
