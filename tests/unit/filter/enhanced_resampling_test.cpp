#include "ddtool/filter/enhanced_resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool {
namespace {

std::vector<SnapshotParticle> swarm(const std::vector<double>& x_m, const std::vector<double>& weights) {
    std::vector<SnapshotParticle> particles(x_m.size());
    for (std::size_t i = 0; i < x_m.size(); ++i) {
        particles[i].pose = {x_m[i], 0.0, 0.1 * static_cast<double>(i)};
        particles[i].weight = weights[i];
    }
    return particles;
}

std::vector<Descendant> resampled(const std::vector<SnapshotParticle>& particles, double perturbation_m,
                                  std::uint64_t seed = 1) {
    EnhancedResamplingSettings settings;
    settings.perturbation_m = perturbation_m;
    RandomStream random{seed};
    return EnhancedResampling(settings).resample(particles, random);
}

TEST(EnhancedResampling, DropsLowWeightsAndFusesTheOthersWithTheirNearest) {
    // The particle nearest to 10 m is the one at 9 m, which is dropped, so 10 m is fused with 4 m. The headings remain
    // those of the parents.
    const auto particles = swarm({0.0, 4.0, 9.0, 10.0}, {0.3, 0.3, 0.05, 0.35});
    const std::vector<double> fused{2.0, 2.0, NAN, 7.0};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const Descendant& descendant : resampled(particles, 0.0, seed)) {
            ASSERT_NE(descendant.parent, 2U);
            EXPECT_NEAR(descendant.pose.x_m, fused[descendant.parent], 1e-12);
            EXPECT_EQ(descendant.pose.theta_rad, particles[descendant.parent].pose.theta_rad);
        }
    }
}

TEST(EnhancedResampling, OfOneHeavyParticleKeepsItsPlace) {
    for (const Descendant& descendant : resampled(swarm({1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}), 0.0)) {
        EXPECT_EQ(descendant.parent, 1U);
        EXPECT_EQ(descendant.pose.x_m, 2.0);
    }
}

TEST(EnhancedResampling, PerturbsLightParticlesMore) {
    const auto particles = swarm({0.0, 1.0}, {0.3, 0.7});
    double moved[2] = {0.0, 0.0};
    double count[2] = {0.0, 0.0};
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        for (const Descendant& descendant : resampled(particles, 0.01, seed)) {
            moved[descendant.parent] += std::pow(descendant.pose.x_m - 0.5, 2);
            count[descendant.parent] += 1.0;
        }
    }
    EXPECT_NEAR(std::sqrt(moved[0] / count[0]), 0.01 / 0.6, 0.002);
    EXPECT_NEAR(std::sqrt(moved[1] / count[1]), 0.01 / 1.4, 0.001);
}

}  // namespace
}  // namespace ddtool
