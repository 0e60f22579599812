#include "ddtool/robot/scan_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <numeric>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

using std::numbers::pi;
constexpr ScanPointsSettings apart{.usable_range_m = 40.0, .spacing_m = 0.0};

/// A scan of beams from -1 to 1 rad, whose ranges are a function of the angle.
SensorFrame scan_of(const std::function<double(double)>& range_m, int beams) {
    SensorFrame frame;
    frame.scan.angle_min_rad = -1.0;
    frame.scan.angle_increment_rad = 2.0 / (beams - 1);
    frame.scan.range_max_m = 50.0;
    for (int beam = 0; beam < beams; ++beam) {
        frame.scan.ranges_m.push_back(
            static_cast<float>(range_m(frame.scan.angle_rad(static_cast<std::size_t>(beam)))));
    }
    return frame;
}

/// The ranges to a wall at `distance_m` from the laser whose normal has the direction normal_rad.
std::function<double(double)> wall(double distance_m, double normal_rad) {
    return [=](double angle_rad) { return distance_m / std::cos(angle_rad - normal_rad); };
}

SensorFrame reversed(SensorFrame frame) {
    std::reverse(frame.scan.ranges_m.begin(), frame.scan.ranges_m.end());
    frame.scan.angle_min_rad += static_cast<double>(frame.scan.ranges_m.size() - 1) * frame.scan.angle_increment_rad;
    frame.scan.angle_increment_rad = -frame.scan.angle_increment_rad;
    return frame;
}

Point2 point(const ScanPoints& points, std::size_t i) {
    return {static_cast<double>(points.x_m[i]), static_cast<double>(points.y_m[i])};
}

void expect_normals_along(const ScanPoints& points, std::size_t i, double normal_rad) {
    const auto nx = static_cast<double>(points.normal_x[i]);
    const auto ny = static_cast<double>(points.normal_y[i]);
    EXPECT_NEAR(std::hypot(nx, ny), 1.0, 1e-6);
    EXPECT_NEAR(nx * std::sin(normal_rad) - ny * std::cos(normal_rad), 0.0, 1e-3) << i;
    EXPECT_LT(points.along_weight[i], 0.02F) << i;
}

TEST(ScanPoints, OfAWallHaveItsNormalAndNoWeightAlongIt) {
    for (const double normal_rad : {-0.4, 0.0, 0.25}) {
        for (const int beams : {61, 401}) {
            const ScanPoints points = scan_points(scan_of(wall(3.0, normal_rad), beams), {});
            ASSERT_GT(points.size(), 50U);
            // the end points are left out, because they have too few neighbours
            for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                expect_normals_along(points, i, normal_rad);
            }
        }
    }
}

TEST(ScanPoints, OfACornerCountInBothDirectionsAtItAndOneBesideIt) {
    const auto left = wall(3.0, pi / 4);
    const auto right = wall(3.0, -pi / 4);
    const ScanPoints points =
        scan_points(scan_of([&](double angle) { return angle > 0.0 ? left(angle) : right(angle); }, 401), {});
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Point2 at = point(points, i);
        if (std::abs(at.y_m) < 0.02) {
            EXPECT_GT(points.along_weight[i], 0.05F) << i;
        } else if (std::abs(at.y_m) > 0.3) {
            expect_normals_along(points, i, at.y_m > 0.0 ? pi / 4 : -pi / 4);
        }
    }
}

/// The noise of the ranges must not be taken for a shape: what is flatter than line_flatness does not show where along
/// the wall a point is.
TEST(ScanPoints, OfANoisyWallHoldNothingAlongIt) {
    RandomStream random{3};
    const auto exact = wall(3.0, 0.0);
    const SensorFrame noisy = scan_of([&](double angle) { return exact(angle) + 0.01 * random.normal(); }, 401);
    const ScanPoints points = scan_points(noisy, {});
    const double mean_weight = std::accumulate(points.along_weight.begin(), points.along_weight.end(), 0.0) /
                               static_cast<double>(points.size());
    // the mean weight that would result if ScanPoints::line_flatness were 0
    constexpr double weight_of_the_noise = 0.00385;
    EXPECT_LT(mean_weight, 0.1 * weight_of_the_noise);
}

TEST(ScanPoints, LieAtTheBeamsEnds) {
    const SensorFrame frame = scan_of(wall(2.0, 0.3), 41);
    const ScanPoints points = scan_points(frame, apart);
    ASSERT_EQ(points.size(), 41U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto range_m = static_cast<double>(frame.scan.ranges_m[i]);
        EXPECT_NEAR(points.x_m[i], range_m * std::cos(frame.scan.angle_rad(i)), 1e-6);
        EXPECT_NEAR(points.y_m[i], range_m * std::sin(frame.scan.angle_rad(i)), 1e-6);
    }
}

TEST(ScanPoints, CrowdedBeamsBecomeOneAtTheirMean) {
    const SensorFrame frame = scan_of([](double angle) { return 0.01 + 0.002 * angle; }, 31);
    const ScanPoints all = scan_points(frame, apart);
    const ScanPoints merged = scan_points(frame, {});
    ASSERT_EQ(all.size(), 31U);
    ASSERT_EQ(merged.size(), 1U);
    Point2 mean;
    for (std::size_t i = 0; i < all.size(); ++i) {
        mean = {mean.x_m + point(all, i).x_m / 31.0, mean.y_m + point(all, i).y_m / 31.0};
    }
    EXPECT_NEAR(merged.x_m[0], mean.x_m, 1e-7);
    EXPECT_NEAR(merged.y_m[0], mean.y_m, 1e-7);
}

TEST(ScanPoints, MergedPointsStayOnTheWallAndFillIt) {
    const ScanPoints points = scan_points(scan_of(wall(2.0, 0.0), 2'001), {});
    EXPECT_LT(points.size(), 250U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(points.x_m[i], 2.0, 1e-5);
        if (i > 0) {
            EXPECT_GT(points.y_m[i] - points.y_m[i - 1], 0.01F);
            EXPECT_LT(points.y_m[i] - points.y_m[i - 1], 0.06F);
        }
    }
}

TEST(ScanPoints, OfAReversedScanAreTheSameTheOtherWayRound) {
    const SensorFrame frame = scan_of([](double angle) { return 2.0 + std::sin(9.0 * angle); }, 181);
    const ScanPoints there = scan_points(frame, apart);
    const ScanPoints back = scan_points(reversed(frame), apart);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        const std::size_t j = there.size() - 1 - i;
        EXPECT_NEAR(there.x_m[i], back.x_m[j], 1e-6);
        EXPECT_NEAR(there.y_m[i], back.y_m[j], 1e-6);
        EXPECT_NEAR(there.normal_x[i] * back.normal_y[j], there.normal_y[i] * back.normal_x[j], 1e-5);
        EXPECT_NEAR(there.along_weight[i], back.along_weight[j], 1e-5);
    }
}

/// A lidar that is mounted upside down turns the other way: the angles are negated and the points mirrored.
TEST(ScanPoints, OfALidarUpsideDownAreMirrored) {
    SensorFrame frame = scan_of([](double angle) { return 2.0 + std::sin(9.0 * angle); }, 181);
    const ScanPoints upright = scan_points(frame, {});
    frame.scan.angle_min_rad = -frame.scan.angle_min_rad;
    frame.scan.angle_increment_rad = -frame.scan.angle_increment_rad;
    const ScanPoints hanging = scan_points(frame, {});
    ASSERT_EQ(upright.size(), hanging.size());
    for (std::size_t i = 0; i < upright.size(); ++i) {
        EXPECT_NEAR(upright.x_m[i], hanging.x_m[i], 1e-6);
        EXPECT_NEAR(upright.y_m[i], -hanging.y_m[i], 1e-6);
        EXPECT_NEAR(upright.along_weight[i], hanging.along_weight[i], 1e-5);
    }
    EXPECT_EQ(upright.order, hanging.order);
}

TEST(ScanPoints, MoveWithTheMounting) {
    SensorFrame frame = scan_of(wall(2.0, 0.3), 181);
    const ScanPoints centred = scan_points(frame, {});
    frame.robot_from_laser = {0.4, -0.2, 2.0};
    const ScanPoints mounted = scan_points(frame, {});
    EXPECT_EQ(mounted.origin_m, (Point2{0.4, -0.2}));
    ASSERT_EQ(mounted.size(), centred.size());
    for (std::size_t i = 0; i < centred.size(); ++i) {
        const Point2 expected = frame.robot_from_laser * point(centred, i);
        EXPECT_NEAR(mounted.x_m[i], expected.x_m, 1e-6);
        EXPECT_NEAR(mounted.y_m[i], expected.y_m, 1e-6);
        if (i > 0 && i + 1 < centred.size()) {
            expect_normals_along(mounted, i, 0.3 + 2.0);
        }
    }
}

TEST(ScanPoints, LeaveOutBeamsThatSayNothingOfASurface) {
    SensorFrame frame = scan_of(wall(2.0, 0.0), 9);
    frame.scan.ranges_m[2] = LaserScan::no_return;
    frame.scan.ranges_m[5] = LaserScan::invalid;
    frame.scan.ranges_m[6] = 45.0F;
    const ScanPoints points = scan_points(frame, {});
    ASSERT_EQ(points.size(), 6U);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool after_a_gap = i == 2 || i == 4;
        EXPECT_EQ(points.order[i] - points.order[i - 1] > 1, after_a_gap) << i;
        EXPECT_TRUE(std::isfinite(points.x_m[i]) && std::isfinite(points.y_m[i]));
    }
}

TEST(ScanPoints, OfNoReturnAreNone) {
    const auto nothing = [](double) { return static_cast<double>(LaserScan::no_return); };
    EXPECT_EQ(scan_points(scan_of(nothing, 50), {}).size(), 0U);
    EXPECT_EQ(scan_points(SensorFrame{}, {}).size(), 0U);
}

TEST(ScanPoints, WithoutNeighboursCountAlikeInEveryDirection) {
    SensorFrame frame = scan_of(wall(2.0, 0.0), 9);
    std::fill(frame.scan.ranges_m.begin() + 1, frame.scan.ranges_m.end(), LaserScan::no_return);
    const ScanPoints points = scan_points(frame, {});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points.normal_x[0], 1.0F);
    EXPECT_EQ(points.normal_y[0], 0.0F);
    EXPECT_EQ(points.along_weight[0], 1.0F);
}

/// Two walls that face the laser, the nearer one on the right. The beam at the edge between them measures mixed_m.
SensorFrame edge(double mixed_m) {
    SensorFrame frame =
        scan_of([](double angle_rad) { return (angle_rad < 0.0 ? 2.0 : 3.0) / std::cos(angle_rad); }, 201);
    frame.scan.ranges_m[100] = static_cast<float>(mixed_m);
    return frame;
}

/// A wall 1 m from the laser with an opening of 0.6 m, behind which another wall lies at the given depth.
SensorFrame wall_with_recess(double depth_m, int beams) {
    return scan_of(
        [=](double angle_rad) { return (std::abs(angle_rad) < 0.3 ? 1.0 + depth_m : 1.0) / std::cos(angle_rad); },
        beams);
}

/// The wall behind an edge must not tilt the normals of the wall before it, nor the other way round.
TEST(ScanPoints, AtAnEdgeHaveTheNormalOfTheirOwnWall) {
    for (const double depth_m : {0.1, 0.15, 0.5}) {
        for (const int beams : {121, 401}) {
            const ScanPoints points = scan_points(wall_with_recess(depth_m, beams), {});
            for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                expect_normals_along(points, i, 0.0);
            }
        }
    }
}

/// Single noisy beams look like edges, and a wall that is cut into pieces at them would hold the robot along itself.
TEST(ScanPoints, OfANoisyWallAreNotCutAtItsNoise) {
    for (const double noise_m : {0.01, 0.02, 0.03}) {
        RandomStream random{5};
        const auto exact = wall(1.0, 0.0);
        const ScanPoints points =
            scan_points(scan_of([&](double angle) { return exact(angle) + noise_m * random.normal(); }, 401), {});
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_EQ(points.order[i] - points.order[i - 1], 1) << noise_m << " m of noise, point " << i;
        }
    }
}

/// A pole that two beams meet is no line, and its normal comes from what is beside it, as everywhere.
TEST(ScanPoints, OnASurfaceTooSmallForALineCountTheirNeighboursOnOthers) {
    SensorFrame frame = scan_of(wall(2.0, 0.0), 401);
    frame.scan.ranges_m[200] = frame.scan.ranges_m[201] = 1.5F;
    const ScanPoints points = scan_points(frame, apart);
    ASSERT_EQ(points.size(), 401U);
    EXPECT_EQ(points.order[200] - points.order[199], 2);
    EXPECT_EQ(points.order[202] - points.order[201], 2);
    EXPECT_LT(points.along_weight[200], 1.0F);
    expect_normals_along(points, 199, 0.0);
    expect_normals_along(points, 202, 0.0);
}

TEST(ScanPoints, LeaveOutABeamThatMixesTheRangesAtAnEdge) {
    const std::size_t all = scan_points(edge(3.0), apart).size();
    for (const double mixed_m : {2.2, 2.5, 2.8}) {
        EXPECT_EQ(scan_points(edge(mixed_m), apart).size(), all - 1) << mixed_m;
        EXPECT_EQ(scan_points(reversed(edge(mixed_m)), apart).size(), all - 1) << mixed_m;
    }
    EXPECT_EQ(scan_points(edge(2.0), apart).size(), all);
}

TEST(ScanPoints, KeepABeamThatStandsAloneBeforeAWall) {
    const std::size_t all = scan_points(edge(3.0), apart).size();
    // 1 m is not between the ranges of its neighbours, so the beam has hit a pole
    EXPECT_EQ(scan_points(edge(1.0), apart).size(), all);
}

TEST(ScanPoints, KeepEveryBeamOfAWallSeenFarAhead) {
    const auto beside = [](double angle_rad) { return 0.5 / std::sin(std::max(std::abs(angle_rad), 0.02)); };
    EXPECT_EQ(scan_points(scan_of(beside, 301), apart).size(), 301U);
}

}  // namespace
}  // namespace ddtool
