#include "particles/spread.hpp"

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

}  // namespace
}  // namespace ddtool
