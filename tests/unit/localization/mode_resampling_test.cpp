#include "localization/mode_resampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ddtool::localization {
namespace {

void add(std::vector<SnapshotParticle>& swarm, std::size_t count, const Pose2& pose, double weight) {
    for (std::size_t i = 0; i < count; ++i) {
        SnapshotParticle particle;
        particle.pose = {pose.x_m + 0.001 * static_cast<double>(i), pose.y_m, pose.theta_rad};
        particle.weight = weight / static_cast<double>(count);
        swarm.push_back(particle);
    }
}

double weight_near(const std::vector<Descendant>& descendants, double x_m) {
    double near = 0.0;
    double all = 0.0;
    for (const Descendant& descendant : descendants) {
        all += descendant.weight;
        near += std::abs(descendant.pose.x_m - x_m) < 1.0 ? descendant.weight : 0.0;
    }
    return near / all;
}

TEST(ModeResampling, PlacesKeepTheirWeights) {
    std::vector<SnapshotParticle> swarm;
    add(swarm, 40, {0.0, 0.0, 0.0}, 0.60);
    add(swarm, 3, {10.0, 0.0, 0.0}, 0.38);
    add(swarm, 5, {20.0, 0.0, 0.0}, 0.02);
    ModeResampling resampling({});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomStream random({seed});
        const std::vector<Descendant> next = resampling.resample(swarm, random);
        EXPECT_NEAR(weight_near(next, 0.0), 0.60, 1e-9);
        EXPECT_NEAR(weight_near(next, 10.0), 0.38, 1e-9);
        EXPECT_NEAR(weight_near(next, 20.0), 0.02, 1e-9);
    }
}

TEST(ModeResampling, TheNumberFollowsTheSpread) {
    const ModeResampling resampling({.least_particles = 30, .most_particles = 200, .kld_error = 0.1});
    std::vector<SnapshotParticle> one;
    add(one, 100, {}, 1.0);
    EXPECT_TRUE(resampling.is_due(one));
    RandomStream random({1});
    EXPECT_EQ(resampling.resample(one, random).size(), 30U);
    std::vector<SnapshotParticle> many;
    for (int place = 0; place < 60; ++place) {
        add(many, 1, {2.0 * place, 0.0, 0.0}, 1.0 / 60.0);
    }
    EXPECT_FALSE(resampling.is_due(many));
    EXPECT_NEAR(static_cast<double>(resampling.resample(many, random).size()), 200.0, 30.0);
    for (int place = 0; place < 300; ++place) {
        add(many, 1, {2.0 * place, 10.0, 0.0}, 1.0 / 300.0);
    }
    EXPECT_LE(resampling.resample(many, random).size(), 203U);
}

/// A search leaves fewer particles than the settings want.
TEST(ModeResampling, AFewParticlesBecomeAsManyAsWanted) {
    const ModeResampling resampling({.least_particles = 500, .most_particles = 500, .kld_error = 0.1});
    std::vector<SnapshotParticle> swarm;
    add(swarm, 90, {}, 1.0);
    EXPECT_TRUE(resampling.is_due(swarm));
    RandomStream random({1});
    EXPECT_EQ(resampling.resample(swarm, random).size(), 500U);
    add(swarm, 400, {}, 1.0);
    EXPECT_FALSE(resampling.is_due(swarm));
}

TEST(ModeResampling, APlaceWithoutWeightIsDropped) {
    std::vector<SnapshotParticle> swarm;
    add(swarm, 10, {}, 1.0 - 1e-6);
    add(swarm, 10, {10.0, 0.0, 0.0}, 1e-6);
    RandomStream random({1});
    EXPECT_EQ(weight_near(ModeResampling({}).resample(swarm, random), 10.0), 0.0);
}

}  // namespace
}  // namespace ddtool::localization
