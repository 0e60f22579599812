#include "ddtool/swarm/swarm_detectors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ddtool/robot/scan_truth.hpp"
#include "swarms.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

ParticleSnapshot snapshot_of(std::vector<SnapshotParticle> particles) {
    ParticleSnapshot swarm;
    swarm.odometry_motion = {0.1, 0.0, 0.0};
    for (SnapshotParticle& particle : particles) {
        particle.weight = 1.0 / static_cast<double>(particles.size());
    }
    swarm.particles = std::move(particles);
    return swarm;
}

TEST(CovarianceDetector, IsAHalfAtItsThresholdAndGrowsWithTheSwarm) {
    const ParticleSnapshot swarm = snapshot_of(test::swarm_at({{-0.1, 0.0}, {0.1, 0.0}}));
    const double sd_m = 0.1 * std::sqrt(2.0);
    EXPECT_NEAR(covariance_detector(sd_m)(swarm).degree, 0.5, 1e-12);
    EXPECT_LT(covariance_detector(10.0 * sd_m)(swarm).degree, 0.01);
    EXPECT_GT(covariance_detector(0.1 * sd_m)(swarm).degree, 0.99);
}

TEST(StepSpreadDetector, IsWhatTheMatchLeavesOfThePrediction) {
    const auto degree = [](double matched_sd_m) {
        return step_spread_detector()(snapshot_of(test::normal_swarm(200, 1, {matched_sd_m, 0.0}, 0.1))).degree;
    };
    EXPECT_NEAR(degree(0.05), 0.5, 1e-3);
    EXPECT_NEAR(degree(0.01), 0.1, 1e-3);
    EXPECT_EQ(degree(0.3), 1.0);
}

TEST(StepSpreadDetector, OfAStandingSwarmIsNotDegenerate) {
    EXPECT_EQ(step_spread_detector()(snapshot_of(std::vector<SnapshotParticle>(3))).degree, 0.0);
}

TEST(EffectiveSizeDetector, IsTheShareOfParticlesWithoutWeight) {
    ParticleSnapshot swarm = snapshot_of(std::vector<SnapshotParticle>(4));
    EXPECT_NEAR(effective_size_detector()(swarm).degree, 0.0, 1e-12);
    for (SnapshotParticle& particle : swarm.particles) {
        particle.weight = 0.0;
    }
    swarm.particles[1].weight = 1.0;
    EXPECT_NEAR(effective_size_detector()(swarm).degree, 0.75, 1e-12);
}

TEST(OracleDetector, WeighsTheScanAgainstTheOdometry) {
    const MotionNoise noise{0.1, 0.0, 0.1, 0.0};
    ParticleSnapshot swarm = snapshot_of({{}});
    const double odometry_variance = 0.1 * 0.1 * 0.1;  // the variance of the odometry along x over 0.1 m
    const auto degree = [&](double x_information) {
        const auto truth = std::make_shared<ScanTruth>();
        truth->add(swarm.stamp_ns, Eigen::Vector3d(x_information, 1e9, 1e9).asDiagonal());
        return oracle_detector(noise, truth)(swarm).degree;
    };
    EXPECT_NEAR(degree(1.0 / odometry_variance), 0.5, 1e-9);
    EXPECT_NEAR(degree(9.0 / odometry_variance), 0.1, 1e-9);
    EXPECT_EQ(degree(0.0), 1.0);
}

TEST(OracleDetector, NeedsTheTruth) {
    const auto truth_of_another = std::make_shared<ScanTruth>();
    truth_of_another->add(1, Eigen::Matrix3d::Identity());
    for (const auto& truth : {std::shared_ptr<ScanTruth>(), truth_of_another}) {
        EXPECT_THAT(test::thrown_text([&] { oracle_detector({}, truth)(snapshot_of({{}})); }),
                    testing::HasSubstr("true Fisher information"));
    }
}

}  // namespace
}  // namespace ddtool
