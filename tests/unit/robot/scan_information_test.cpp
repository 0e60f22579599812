#include "robot/scan_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace ddtool {
namespace {

/// End points on walls: each (x, y) with its unit normal.
ScanPoints points_on(const std::function<void(ScanPoints&)>& build) {
    ScanPoints points;
    build(points);
    points.along_weight.assign(points.x_m.size(), 0.0F);
    return points;
}

void add_wall(ScanPoints& points, double distance_m, double normal_rad) {
    for (int i = -10; i <= 10; ++i) {
        const double along_m = 0.2 * i;
        points.x_m.push_back(static_cast<float>(distance_m * std::cos(normal_rad) - along_m * std::sin(normal_rad)));
        points.y_m.push_back(static_cast<float>(distance_m * std::sin(normal_rad) + along_m * std::cos(normal_rad)));
        points.normal_x.push_back(static_cast<float>(std::cos(normal_rad)));
        points.normal_y.push_back(static_cast<float>(std::sin(normal_rad)));
    }
}

ScanPoints corridor(double along_rad) {
    return points_on([&](ScanPoints& points) {
        add_wall(points, 1.0, along_rad + std::numbers::pi / 2);
        add_wall(points, -1.0, along_rad + std::numbers::pi / 2);
    });
}

TEST(ScanInformation, OfACorridorIsNothingAlongIt) {
    for (const double along_rad : {0.0, 0.7, 2.0}) {
        const Eigen::Matrix3d information = scan_information(corridor(along_rad), 0.05);
        const Eigen::Vector3d along(std::cos(along_rad), std::sin(along_rad), 0.0);
        const Eigen::Vector3d across(-std::sin(along_rad), std::cos(along_rad), 0.0);
        EXPECT_NEAR(along.dot(information * along), 0.0, 1e-3);
        EXPECT_NEAR(across.dot(information * across), 42.0 / (0.05 * 0.05), 1.0);
        EXPECT_GT(information(2, 2), 1.0);
    }
}

TEST(ScanInformation, AddsOverPoints) {
    const ScanPoints left = corridor(0.2);
    ScanPoints both = left;
    add_wall(both, 3.0, 0.2);
    both.along_weight.assign(both.x_m.size(), 0.0F);
    const ScanPoints right = points_on([](ScanPoints& points) { add_wall(points, 3.0, 0.2); });
    EXPECT_TRUE(
        scan_information(both, 0.05).isApprox(scan_information(left, 0.05) + scan_information(right, 0.05), 1e-6));
}

TEST(ScanInformation, OfAPointWithoutSurfaceHoldsBothWays) {
    ScanPoints pole = points_on([](ScanPoints& points) { add_wall(points, 2.0, 0.0); });
    pole.along_weight.assign(pole.x_m.size(), 1.0F);
    const Eigen::Matrix3d information = scan_information(pole, 0.1);
    EXPECT_NEAR(information(0, 0), 2100.0, 1e-6);
    EXPECT_NEAR(information(1, 1), 2100.0, 1e-6);
}

TEST(ScanInformation, OfNothingIsNothing) { EXPECT_TRUE(scan_information({}, 0.05).isZero()); }

}  // namespace
}  // namespace ddtool
