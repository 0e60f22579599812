#include "network/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "swarms.hpp"

namespace ddtool {
namespace {

constexpr double least_spread_m = 0.001;

/// A swarm whose predictions have a standard deviation of 0.1 m along x and 0.03 m along y. Matching leaves the given
/// shares of the deviations.
std::vector<SnapshotParticle> swarm_left_with(double share_x, double share_y, std::uint64_t seed = 1) {
    std::vector<SnapshotParticle> particles = test::normal_swarm(60, seed, {});
    for (SnapshotParticle& particle : particles) {
        particle.matched_motion = {0.5 + share_x * particle.predicted_motion.x_m,
                                   -2.0 + share_y * particle.predicted_motion.y_m, 0.0};
    }
    return particles;
}

std::vector<Point2> response_of(const std::vector<SnapshotParticle>& particles) {
    std::vector<Point2> points;
    response(particles, least_spread_m, points);
    return points;
}

double slope(const std::vector<Point2>& points) {
    double xx = 0.0;
    double xy = 0.0;
    for (const Point2& point : points) {
        xx += point.x_m * point.x_m;
        xy += point.x_m * point.y_m;
    }
    return xy / xx;
}

TEST(Response, ItsSlopeIsTheShareThatMatchingLeavesOfTheWidestDirection) {
    EXPECT_NEAR(slope(response_of(swarm_left_with(1.0, 0.0))), 1.0, 1e-9);
    EXPECT_NEAR(slope(response_of(swarm_left_with(0.3, 0.3))), 0.3, 1e-9);
    EXPECT_NEAR(slope(response_of(swarm_left_with(0.02, 0.01))), 0.02, 0.005);
}

TEST(Response, FindsADirectionInWhichLittleWasPredicted) {
    // Along y, matching leaves all of the predicted 0.03 m; along x, it leaves only a tenth of the 0.1 m. So y is the
    // weakest direction, although less spread was predicted along it.
    EXPECT_NEAR(slope(response_of(swarm_left_with(0.1, 1.0))), 1.0, 0.02);
}

TEST(Response, IsTheSameFromEverySideUpToAHalfTurn) {
    const std::vector<SnapshotParticle> swarm = swarm_left_with(0.8, 0.1);
    const std::vector<Point2> points = response_of(swarm);
    for (double angle = 0.1; angle < 6.0; angle += 0.7) {
        std::vector<SnapshotParticle> turned = swarm;
        for (SnapshotParticle& particle : turned) {
            particle.predicted_motion = Pose2{0.0, 0.0, angle} * particle.predicted_motion;
            particle.matched_motion = Pose2{0.0, 0.0, angle} * particle.matched_motion;
        }
        const std::vector<Point2> seen = response_of(turned);
        const double sign = seen.front().x_m * points.front().x_m > 0.0 ? 1.0 : -1.0;
        for (std::size_t index = 0; index < points.size(); ++index) {
            EXPECT_NEAR(seen[index].x_m, sign * points[index].x_m, 1e-9);
            EXPECT_NEAR(seen[index].y_m, sign * points[index].y_m, 1e-9);
        }
    }
}

TEST(Response, HasTheSpreadOfThePredictionForItsUnit) {
    std::vector<SnapshotParticle> larger = swarm_left_with(0.5, 0.2);
    const std::vector<Point2> points = response_of(larger);
    for (SnapshotParticle& particle : larger) {
        particle.predicted_motion.x_m *= 7.0;
        particle.predicted_motion.y_m *= 7.0;
        particle.matched_motion.x_m *= 7.0;
        particle.matched_motion.y_m *= 7.0;
    }
    const std::vector<Point2> seen = response_of(larger);
    for (std::size_t index = 0; index < points.size(); ++index) {
        EXPECT_NEAR(std::abs(seen[index].x_m), std::abs(points[index].x_m), 1e-9);
    }
}

TEST(Response, APredictionWithoutNoiseLeavesSmallNumbers) {
    std::vector<SnapshotParticle> still(3);
    still[1].matched_motion.x_m = 0.002;
    for (const Point2& point : response_of(still)) {
        EXPECT_EQ(point.x_m, 0.0);
        EXPECT_LT(std::abs(point.y_m), 2.0);
    }
}

TEST(Response, LeavesOutWhatIsNotFinite) {
    std::vector<SnapshotParticle> particles = swarm_left_with(1.0, 1.0);
    const std::vector<Point2> points = response_of(particles);
    particles.resize(particles.size() + 2);
    particles[60].matched_motion.x_m = std::numeric_limits<double>::quiet_NaN();
    particles[61].predicted_motion.y_m = std::numeric_limits<double>::infinity();
    const std::vector<Point2> seen = response_of(particles);
    ASSERT_EQ(seen.size(), points.size());
    EXPECT_EQ(seen.back().y_m, points.back().y_m);
    EXPECT_TRUE(response_of({}).empty());
    EXPECT_EQ(response_of(std::vector<SnapshotParticle>(1)).front().y_m, 0.0);
}

}  // namespace
}  // namespace ddtool
