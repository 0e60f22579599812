#include "sim/ray_caster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool::sim {
namespace {

constexpr double pi = std::numbers::pi;

World square_room(double half_m) {
    World world;
    add_box(world, {}, 2.0 * half_m, 2.0 * half_m);
    return world;
}

World random_world(std::uint64_t seed) {
    RandomStream random({seed});
    World world;
    const auto place = [&] { return Point2{random.uniform(-20.0, 20.0), random.uniform(-12.0, 12.0)}; };
    for (int i = 0; i < 30; ++i) {
        world.segments.push_back({place(), place()});
        world.arcs.push_back(
            {place(), random.uniform(0.05, 4.0), random.uniform(-pi, pi), random.uniform(0.1, 2 * pi)});
    }
    return world;
}

std::optional<Hit> cast_by_trying_all(const World& world, const Ray& ray, double max_range_m) {
    std::optional<Hit> nearest;
    const auto consider = [&](const auto& surface) {
        const std::optional<Hit> hit = intersect(ray, surface);
        if (hit && hit->range_m <= max_range_m && (!nearest || hit->range_m < nearest->range_m)) {
            nearest = hit;
        }
    };
    std::for_each(world.segments.begin(), world.segments.end(), consider);
    std::for_each(world.arcs.begin(), world.arcs.end(), consider);
    return nearest;
}

TEST(RayCaster, SeesTheWallsOfASquareRoomWhereTheyAre) {
    const RayCaster caster(square_room(5.0));
    RandomStream random({1});
    for (int i = 0; i < 1000; ++i) {
        const double angle_rad = random.uniform(-pi, pi);
        const auto hit = caster.cast(ray_at({0.0, 0.0}, angle_rad), 30.0);
        ASSERT_TRUE(hit);
        const double larger = std::max(std::abs(std::cos(angle_rad)), std::abs(std::sin(angle_rad)));
        EXPECT_NEAR(hit->range_m, 5.0 / larger, 1e-12);
    }
}

TEST(RayCaster, SeesACircleFromWithinAtTheExactDistance) {
    World world;
    world.arcs.push_back({.centre = {1.0, 2.0}, .radius_m = 4.0});
    const RayCaster caster(world);
    RandomStream random({2});
    for (int i = 0; i < 1000; ++i) {
        // The length of the chord from a point at the distance d from the centre is -d cos(a) + sqrt(r^2 - d^2
        // sin(a)^2).
        const double d = random.uniform(0.0, 3.9);
        const double angle_rad = random.uniform(-pi, pi);
        const auto hit = caster.cast(ray_at({1.0 + d, 2.0}, angle_rad), 30.0);
        ASSERT_TRUE(hit);
        const double across = d * std::sin(angle_rad);
        EXPECT_NEAR(hit->range_m, -d * std::cos(angle_rad) + std::sqrt(16.0 - across * across), 1e-9);
    }
}

TEST(RayCaster, GoesThroughTheGapOfAnArc) {
    World world;
    world.arcs.push_back({.centre = {}, .radius_m = 3.0, .start_rad = 0.5, .sweep_rad = 2.0 * pi - 1.0});
    const RayCaster caster(world);
    EXPECT_FALSE(caster.cast(ray_at({}, 0.0), 30.0));
    EXPECT_FALSE(caster.cast(ray_at({}, -0.49), 30.0));
    EXPECT_NEAR(caster.cast(ray_at({}, 0.51), 30.0)->range_m, 3.0, 1e-12);
    // From outside, the far side is seen through the gap.
    EXPECT_NEAR(caster.cast(ray_at({5.0, 0.0}, pi), 30.0)->range_m, 8.0, 1e-12);
}

TEST(RayCaster, ReportsNothingBeyondTheRange) {
    const RayCaster caster(square_room(5.0));
    EXPECT_TRUE(caster.cast(ray_at({}, 0.0), 5.001));
    EXPECT_FALSE(caster.cast(ray_at({}, 0.0), 4.999));
    EXPECT_FALSE(RayCaster(World{}).cast(ray_at({}, 0.0), 100.0));
}

TEST(RayCaster, NormalsAreUnitLengthAndFaceTheRay) {
    const RayCaster caster(random_world(3));
    RandomStream random({3});
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = ray_at({random.uniform(-20.0, 20.0), random.uniform(-12.0, 12.0)}, random.uniform(-pi, pi));
        if (const auto hit = caster.cast(ray, 100.0)) {
            EXPECT_NEAR(std::hypot(hit->normal.x_m, hit->normal.y_m), 1.0, 1e-9);
            EXPECT_LE(hit->normal.x_m * ray.direction.x_m + hit->normal.y_m * ray.direction.y_m, 0.0);
        }
    }
}

class RayCasterGrid : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RayCasterGrid, AgreesWithTryingEverySurface) {
    const World world = random_world(GetParam());
    const RayCaster caster(world);
    RandomStream random({GetParam(), 1});
    for (int i = 0; i < 2000; ++i) {
        // Some origins lie outside of the grid, and some angles are exactly along the axes.
        const Point2 origin{random.uniform(-40.0, 40.0), random.uniform(-30.0, 30.0)};
        const double angle_rad = i % 4 == 0 ? pi / 2.0 * static_cast<double>(random.index(4)) : random.uniform(-pi, pi);
        const double max_range_m = random.uniform(1.0, 60.0);
        const Ray ray = ray_at(origin, angle_rad);
        const auto hit = caster.cast(ray, max_range_m);
        const auto expected = cast_by_trying_all(world, ray, max_range_m);
        ASSERT_EQ(hit.has_value(), expected.has_value()) << "ray " << i;
        if (hit) {
            ASSERT_EQ(hit->range_m, expected->range_m) << "ray " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Worlds, RayCasterGrid, testing::Range<std::uint64_t>(0, 8));

TEST(RayCaster, MovesWithTheWorld) {
    const Pose2 moved_from_world{300.0, -200.0, 0.7};
    World world;
    World moved;
    for (int i = 0; i < 6; ++i) {
        const Pose2 box{3.0 + i, 2.0 * i - 6.0, 0.3 * i};
        add_box(world, box, 1.0, 0.5);
        add_box(moved, moved_from_world * box, 1.0, 0.5);
    }
    const RayCaster caster(world);
    const RayCaster moved_caster(moved);
    for (int i = 0; i < 500; ++i) {
        const double angle_rad = -1.5 + 3.0 * i / 500.0;
        const auto hit = caster.cast(ray_at({}, angle_rad), 50.0);
        const auto moved_hit = moved_caster.cast(ray_at(moved_from_world * Point2{}, 0.7 + angle_rad), 50.0);
        ASSERT_EQ(hit.has_value(), moved_hit.has_value());
        if (hit) {
            EXPECT_NEAR(hit->range_m, moved_hit->range_m, 1e-9);
        }
    }
}

}  // namespace
}  // namespace ddtool::sim
