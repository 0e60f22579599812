#include "study/judge/measures.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ddtool/base/random.hpp"
#include "swarms.hpp"

namespace ddtool::judge {
namespace {

using ddtool::test::normal_swarm;

std::vector<SnapshotParticle> weighted_swarm() {
    std::vector<SnapshotParticle> swarm = normal_swarm(30, 4, {0.3, 0.1});
    RandomStream random({9});
    double sum = 0.0;
    for (SnapshotParticle& particle : swarm) {
        particle.weight = random.uniform();
        particle.log_likelihood = -10.0 * random.uniform();
        sum += particle.weight;
    }
    for (SnapshotParticle& particle : swarm) {
        particle.weight /= sum;
    }
    return swarm;
}

std::vector<SnapshotParticle> turned(std::vector<SnapshotParticle> swarm, const Pose2& by, double scale) {
    for (SnapshotParticle& particle : swarm) {
        for (Pose2 SnapshotParticle::*position :
             {&SnapshotParticle::pose, &SnapshotParticle::matched_motion, &SnapshotParticle::predicted_motion}) {
            Pose2& at = particle.*position;
            at = by * Pose2{scale * at.x_m, scale * at.y_m, at.theta_rad};
        }
    }
    return swarm;
}

TEST(SimpleMeasures, DoNotMindWhereTheSwarmIsAndHowItLies) {
    const auto swarm = weighted_swarm();
    const auto moved = turned(swarm, {3.0, -8.0, 0.7}, 1.0);
    for (const Measure& measure : simple_measures({})) {
        EXPECT_NEAR(measure.value(moved), measure.value(swarm), 1e-9) << measure.name << measure.swarm;
        EXPECT_GT(measure.value(swarm), 0.0);
    }
}

TEST(SimpleMeasures, GrowWithTheSwarmAsTheirUnitsSay) {
    const auto swarm = weighted_swarm();
    const auto doubled = turned(swarm, {}, 2.0);
    for (const Measure& measure : simple_measures({})) {
        const bool square = measure.name.starts_with("Switch") && measure.swarm != "weights";
        const double factor = square ? 4.0 : measure.name == "spread" ? 2.0 : 1.0;
        EXPECT_NEAR(measure.value(doubled), factor * measure.value(swarm), 1e-9) << measure.name << measure.swarm;
    }
}

TEST(SimpleMeasures, OfEqualWeights) {
    std::vector<SnapshotParticle> swarm = weighted_swarm();
    for (SnapshotParticle& particle : swarm) {
        particle.weight = 1.0 / 30.0;
    }
    const auto measures = simple_measures({});
    const auto value = [&](std::size_t which) { return measures[which].value(swarm); };
    EXPECT_NEAR(value(1), 1.0, 1e-12) << measures[1].name;
    EXPECT_NEAR(value(2), 0.0, 1e-12) << measures[2].name;
    EXPECT_NEAR(value(3), value(5) * value(5), 1e-12) << "the weighted covariance is the plain one";
}

TEST(SimpleMeasures, ROfTheWeightThatTheLabelTakes) {
    const auto swarm = weighted_swarm();
    const auto all = dataset::dispersions(swarm);
    EXPECT_EQ(simple_measures({})[0].value(swarm), all[0]);
    EXPECT_EQ(simple_measures({.dispersion_weight = "weight"})[0].value(swarm), all[3]);
}

TEST(CovarianceFeatures, AreFiniteForASwarmThatIsAPoint) {
    const std::vector<SnapshotParticle> point(3);
    EXPECT_TRUE(covariance_features(point).allFinite());
    const auto swarm = weighted_swarm();
    const Eigen::VectorXd plain = covariance_features(swarm);
    const Eigen::VectorXd doubled = covariance_features(turned(swarm, {1.0, 2.0, 0.3}, 2.0));
    EXPECT_NEAR((doubled - plain).head(plain.size() - 1).minCoeff(), std::log(2.0), 1e-9);
    EXPECT_NEAR((doubled - plain).head(plain.size() - 1).maxCoeff(), std::log(2.0), 1e-9);
    EXPECT_EQ(doubled[plain.size() - 1], plain[plain.size() - 1]);
}

}  // namespace
}  // namespace ddtool::judge
