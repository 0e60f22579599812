#include "ddtool/filter/strategies.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

std::vector<SnapshotParticle> swarm(const std::vector<double>& weights) {
    std::vector<SnapshotParticle> particles;
    for (const double weight : weights) {
        SnapshotParticle particle;
        particle.pose.x_m = static_cast<double>(particles.size());
        particle.weight = weight;
        particles.push_back(particle);
    }
    return particles;
}

TEST(SystematicResampling, OfEqualWeightsKeepsEveryParticleInPlace) {
    const std::vector<SnapshotParticle> particles = swarm(std::vector<double>(8, 0.125));
    RandomStream random{1};
    const std::vector<Descendant> next = SystematicResampling().resample(particles, random);
    ASSERT_EQ(next.size(), 8U);
    for (std::size_t i = 0; i < next.size(); ++i) {
        EXPECT_EQ(next[i].parent, i);
        EXPECT_EQ(next[i].pose, particles[i].pose);
    }
}

TEST(SystematicResampling, DescendantsStandWhereTheirParentsDid) {
    const std::vector<SnapshotParticle> particles = swarm({0.1, 0.0, 0.6, 0.3});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomStream random{seed};
        for (const Descendant& descendant : SystematicResampling().resample(particles, random)) {
            EXPECT_NE(descendant.parent, 1U);
            EXPECT_EQ(descendant.pose, particles[descendant.parent].pose);
        }
    }
}

}  // namespace
}  // namespace ddtool
