#include "sim/fisher_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ddtool::sim {
namespace {

constexpr std::int64_t at_start = 0;

Eigen::Matrix3d information_in(const World& world, const Pose2& robot, const Pose2& mounting,
                               const LidarSettings& settings) {
    const LaserScan scan = blank_scan(settings, at_start);
    return fisher_information(scan, cast_beams(scan, {robot * mounting}, RayCaster(world)), robot, mounting, settings);
}

/// The information computed numerically: the sum, over the beams, of the outer products of the central differences of
/// the ray caster's ranges.
Eigen::Matrix3d numerical_information(const World& world, const Pose2& robot, const Pose2& mounting,
                                      const LidarSettings& settings) {
    constexpr double step = 1e-6;
    const RayCaster caster(world);
    const LaserScan scan = blank_scan(settings, at_start);
    const auto hits_after = [&](const Pose2& motion) { return cast_beams(scan, {robot * motion * mounting}, caster); };
    const BeamHits hits[3][2] = {{hits_after({step, 0, 0}), hits_after({-step, 0, 0})},
                                 {hits_after({0, step, 0}), hits_after({0, -step, 0})},
                                 {hits_after({0, 0, step}), hits_after({0, 0, -step})}};
    const BeamHits here = hits_after({});
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (std::size_t beam = 0; beam < here.size(); ++beam) {
        Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
        for (int i = 0; here[beam] && i < 3; ++i) {
            gradient[i] = (hits[i][0][beam]->range_m - hits[i][1][beam]->range_m) / (2.0 * step);
        }
        const double sd_m = here[beam] ? range_sd_m(settings, here[beam]->range_m) : 1.0;
        information += gradient.transpose() * gradient * (1.0 - settings.drop_out_probability) / (sd_m * sd_m);
    }
    return information;
}

LidarSettings few_beams() {
    return {.beams = 97, .range_max_m = 100.0, .range_noise_m = 0.01, .range_noise_per_m = 0.001};
}

int rank(const Eigen::Matrix3d& information) {
    const Eigen::Vector3d eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information).eigenvalues();
    return static_cast<int>((eigenvalues.array() > 1e-9 * eigenvalues[2]).count());
}

/// Two walls that are infinite as far as the lidar can see.
World corridor(double heading_rad) {
    World world;
    const Pose2 world_from_corridor{0.0, 0.0, heading_rad};
    for (const double side_m : {-1.0, 1.3}) {
        world.segments.push_back(
            {world_from_corridor * Point2{-1e4, side_m}, world_from_corridor * Point2{1e4, side_m}});
    }
    return world;
}

TEST(FisherInformation, AgreesWithNumericalDifferencesOfTheRayCaster) {
    World world;
    add_box(world, {0.3, -0.2, 0.4}, 12.0, 7.0);
    world.arcs.push_back({.centre = {3.0, 1.0}, .radius_m = 0.8});
    const Pose2 mounting{0.15, -0.05, 0.6};
    for (const Pose2& robot : {Pose2{0.0, 0.0, 0.0}, Pose2{-2.0, 1.0, 2.0}, Pose2{1.0, -1.5, -0.7}}) {
        const Eigen::Matrix3d exact = information_in(world, robot, mounting, few_beams());
        const Eigen::Matrix3d numerical = numerical_information(world, robot, mounting, few_beams());
        EXPECT_LT((exact - numerical).norm(), 1e-5 * exact.norm()) << exact << "\n\n" << numerical;
    }
}

TEST(FisherInformation, OfARoomIsOfFullRank) {
    World world;
    add_box(world, {}, 10.0, 10.0);
    EXPECT_EQ(rank(information_in(world, {0.5, 1.0, 0.3}, {}, few_beams())), 3);
}

TEST(FisherInformation, OfACorridorLosesTheDirectionAlongItAlone) {
    const Pose2 robot{0.4, 0.1, 0.7};
    const double corridor_heading_rad = 0.3;
    const Eigen::Matrix3d information = information_in(corridor(corridor_heading_rad), robot, {}, few_beams());
    EXPECT_EQ(rank(information), 2);
    const double in_robot_rad = corridor_heading_rad - robot.theta_rad;
    const Eigen::Vector3d along(std::cos(in_robot_rad), std::sin(in_robot_rad), 0.0);
    EXPECT_LT((information * along).norm(), 1e-9 * information.norm());
}

/// With the lidar at the centre of a circle, the scan does not determine the heading, but it does determine the
/// position.
TEST(FisherInformation, AtTheCentreOfACircleLosesTheHeadingAlone) {
    World world;
    world.arcs.push_back({.centre = {1.0, 1.0}, .radius_m = 4.0});
    const Eigen::Matrix3d information = information_in(world, {1.0, 1.0, 0.2}, {}, few_beams());
    EXPECT_EQ(rank(information), 2);
    EXPECT_LT((information * Eigen::Vector3d::UnitZ()).norm(), 1e-9 * information.norm());
}

/// A straight wall determines the distance from it and the heading: two of three numbers.
TEST(FisherInformation, OfASingleWallLosesThePlaceAlongItAlone) {
    World world;
    world.segments.push_back({{2.0, -1e4}, {2.0, 1e4}});
    const Eigen::Matrix3d information = information_in(world, {}, {}, few_beams());
    EXPECT_EQ(rank(information), 2);
    EXPECT_LT((information * Eigen::Vector3d::UnitY()).norm(), 1e-9 * information.norm());
}

/// One beam measures one number, so two of three remain undetermined.
TEST(FisherInformation, OfASingleBeamLosesTwo) {
    World world;
    world.segments.push_back({{2.0, -1.0}, {2.0, 1.0}});
    LidarSettings settings = few_beams();
    settings.beams = 8;
    EXPECT_EQ(rank(information_in(world, {}, {}, settings)), 1);
}

TEST(FisherInformation, OfEmptySpaceIsZero) {
    EXPECT_EQ(information_in(World{}, {}, {}, few_beams()), Eigen::Matrix3d::Zero());
}

TEST(FisherInformation, FallsWithTheSquareOfTheNoise) {
    World world;
    add_box(world, {}, 8.0, 5.0);
    LidarSettings settings = few_beams();
    const Eigen::Matrix3d information = information_in(world, {}, {}, settings);
    settings.range_noise_m *= 3.0;
    settings.range_noise_per_m *= 3.0;
    EXPECT_LT((9.0 * information_in(world, {}, {}, settings) - information).norm(), 1e-12 * information.norm());
}

TEST(FisherInformation, IsTheRobotsOwnWhereverTheWorldIs) {
    const Pose2 moved_from_world{30.0, -12.0, 1.1};
    World world;
    World moved;
    add_box(world, {}, 9.0, 6.0);
    add_box(moved, moved_from_world, 9.0, 6.0);
    const Pose2 robot{1.0, 0.5, 0.2};
    const Eigen::Matrix3d here = information_in(world, robot, {}, few_beams());
    const Eigen::Matrix3d there = information_in(moved, moved_from_world * robot, {}, few_beams());
    EXPECT_LT((here - there).norm(), 1e-9 * here.norm());
}

}  // namespace
}  // namespace ddtool::sim
