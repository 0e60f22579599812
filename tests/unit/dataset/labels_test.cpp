#include "dataset/labels.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ddtool/base/error.hpp"
#include "ddtool/robot/pose2.hpp"
#include "swarm/physical_degeneracy.hpp"

namespace ddtool::dataset {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr MotionSigmas odometry{0.03, 0.01, 0.02};

LabelSettings threshold(double value) { return {"log_likelihood", value, 1.0}; }
LabelSettings of_weight(const std::string& name) { return {name, 1.0, 1.0}; }
LabelSettings ratio(double value) { return {"log_likelihood", 1.0, value}; }

/// The information of two beams that hit a wall whose normal has the direction normal_rad, at the distance reach_m to
/// each side of the foot of the perpendicular from the laser.
Eigen::Matrix3d wall(double normal_rad, double reach_m, double information = 1e4) {
    const Eigen::Vector3d left(std::cos(normal_rad), std::sin(normal_rad), reach_m);
    const Eigen::Vector3d right(std::cos(normal_rad), std::sin(normal_rad), -reach_m);
    return information * (left * left.transpose() + right * right.transpose());
}

TEST(PhysicalDegeneracy, CorridorIsLostAlongIt) {
    for (const double along_rad : {0.0, 0.4, 1.2}) {
        const Eigen::Matrix3d corridor = 2.0 * wall(along_rad + std::numbers::pi / 2, 3.0);
        const PhysicalDegeneracy found = physical_degeneracy(corridor, odometry);
        EXPECT_EQ(found.weak_sd_m, infinity);
        EXPECT_NEAR(found.weak_direction_rad, along_rad, 1e-9);
        EXPECT_NEAR(found.strong_sd_m, 0.005, 1e-9);
        EXPECT_NEAR(found.odometry_sd_m, std::hypot(0.03 * std::cos(along_rad), 0.01 * std::sin(along_rad)), 1e-9);
    }
}

TEST(PhysicalDegeneracy, RoomIsHeldBothWaysAndTheWeakWayIsTheOneOfLessInformation) {
    const Eigen::Matrix3d room = wall(0.0, 2.0, 100.0) + wall(std::numbers::pi / 2, 2.0, 400.0);
    const PhysicalDegeneracy found = physical_degeneracy(room, odometry);
    EXPECT_NEAR(found.weak_sd_m, 1.0 / std::sqrt(200.0), 1e-12);
    EXPECT_NEAR(found.strong_sd_m, 1.0 / std::sqrt(800.0), 1e-12);
    EXPECT_NEAR(found.weak_direction_rad, 0.0, 1e-9);
}

TEST(PhysicalDegeneracy, IsTheBoundOfTheInverse) {
    Eigen::Matrix3d information = wall(0.3, 2.0) + wall(1.5, 4.0, 300.0);
    information += Eigen::Vector3d(3.0, -2.0, 40.0) * Eigen::RowVector3d(3.0, -2.0, 40.0);
    const Eigen::Matrix3d covariance = information.inverse();
    const PhysicalDegeneracy found = physical_degeneracy(information, odometry);
    const Eigen::Vector2d weak(std::cos(found.weak_direction_rad), std::sin(found.weak_direction_rad));
    EXPECT_NEAR(weak.dot(covariance.topLeftCorner<2, 2>() * weak), found.weak_sd_m * found.weak_sd_m, 1e-9);
    EXPECT_NEAR(covariance(0, 0) + covariance(1, 1),
                found.weak_sd_m * found.weak_sd_m + found.strong_sd_m * found.strong_sd_m, 1e-9);
}

TEST(PhysicalDegeneracy, NothingSeenIsLostEveryWay) {
    const PhysicalDegeneracy found = physical_degeneracy(Eigen::Matrix3d::Zero(), odometry);
    EXPECT_EQ(found.weak_sd_m, infinity);
    EXPECT_EQ(found.strong_sd_m, infinity);
}

TEST(InformationOnMap, CountsTheCellAsNoiseOfTheSurface) {
    const Eigen::Matrix3d room = wall(0.0, 2.0) + wall(1.0, 2.0);
    EXPECT_TRUE(information_on_map(room, 0.02, 0.0).isApprox(room));
    // a cell's standard deviation, cell_m / sqrt(12), is then equal to the beam's, so the variance doubles
    const double cell_m = 0.02 * std::sqrt(12.0);
    EXPECT_TRUE(information_on_map(room, 0.02, cell_m).isApprox(0.5 * room));
}

TEST(Dispersions, AreThoseOfEachWeight) {
    const std::vector<SnapshotParticle> swarm{{{}, {}, {}, -10.0, -2.0, 0.5, 0.25},
                                              {{}, {}, {}, -30.0, -2.0, 1.0, 0.75}};
    const auto [accumulated, increment, score, weight] = dispersions(swarm);
    EXPECT_DOUBLE_EQ(accumulated, 5.0);  // the variance is 100, and the magnitude of the mean 20
    EXPECT_DOUBLE_EQ(increment, 0.0);
    EXPECT_DOUBLE_EQ(score, 0.0625 / 0.75);
    EXPECT_DOUBLE_EQ(weight, 0.0625 / 0.5);
}

TEST(DispersionLabel, AsksTheNamedWeightForMoreThanTheThreshold) {
    const std::array<double, 4> values{1.5, 1.0, 0.1, 0.0};
    EXPECT_EQ(dispersion_label(values, {}), Label::degenerate);
    EXPECT_EQ(dispersion_label(values, threshold(2.0)), Label::not_degenerate);
    EXPECT_EQ(dispersion_label(values, of_weight("log_likelihood_increment")), Label::not_degenerate);
    EXPECT_THROW(dispersion_label(values, of_weight("luck")), UsageError);
}

TEST(FisherLabel, ComparesTheScanWithTheOdometry) {
    EXPECT_EQ(fisher_label(0.02, 0.03, {}), Label::not_degenerate);
    EXPECT_EQ(fisher_label(0.04, 0.03, {}), Label::degenerate);
    EXPECT_EQ(fisher_label(0.04, 0.03, ratio(2.0)), Label::not_degenerate);
    EXPECT_EQ(fisher_label(infinity, 0.03, {}), Label::degenerate);
    EXPECT_EQ(fisher_label(nan, 0.03, {}), Label::unknown);
}

}  // namespace
}  // namespace ddtool::dataset
