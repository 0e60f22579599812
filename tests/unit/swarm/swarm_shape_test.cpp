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
    auto doubled = test::swarm_at({{0, 0}, {1, 0}, {1, 0}, {0, 2}});
    doubled = with_equal_weights(doubled);
    auto weighted = test::swarm_at({{0, 0}, {1, 0}, {0, 2}});
    weighted[0].weight = weighted[2].weight = 0.25;
    weighted[1].weight = 0.5;
    const SwarmShape a = swarm_shape(doubled, &SnapshotParticle::pose);
    const SwarmShape b = swarm_shape(weighted, &SnapshotParticle::pose);
    // The direction and the ratio are the same; the correction for few particles knows that two share a place.
    EXPECT_NEAR(a.major_direction_rad, b.major_direction_rad, 1e-12);
    EXPECT_NEAR(a.major_variance_m2 / a.minor_variance_m2, b.major_variance_m2 / b.minor_variance_m2, 1e-9);
}

TEST(SwarmShape, OfOneParticleIsAPoint) {
    const auto one = with_equal_weights(test::swarm_at({{4, 5}}));
    EXPECT_EQ(swarm_shape(one, &SnapshotParticle::pose).major_variance_m2, 0.0);
}

}  // namespace
}  // namespace ddtool
