#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"
#include "sim/random_purpose.hpp"
#include "sim/random_worlds.hpp"

namespace ddtool::sim {
namespace {

/// Least distance of the middle of a landmark from the route; for a wall, half its length is added.
constexpr double route_margin_m = 1.5;

/// A loop around the origin, each corner at a random distance from it.
Route draw_loop(double field_m, RandomStream& random) {
    const std::size_t corners = 5 + random.index(5);
    std::vector<Point2> points;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        const double radius_m = field_m * random.uniform(0.2, 0.4);
        points.push_back({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)});
    }
    const Point2 first = points[0];
    std::rotate(points.begin(), points.begin() + 1, points.end());
    return {.start = {first.x_m, first.y_m, std::numbers::pi / 2.0}, .way_points = points};
}

double distance_to_route(const Route& route, const Point2& point) {
    const Point2 nearest = nearest_on_route(route, point);
    return std::hypot(nearest.x_m - point.x_m, nearest.y_m - point.y_m);
}

}  // namespace

World random_open(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 3});
    const double field_m = random.uniform(40.0, 120.0);
    World world{.name = "random:open:" + std::to_string(seed),
                .description = "open ground with landmarks, drawn by seed",
                .segments = {},
                .arcs = {},
                .route = draw_loop(field_m, random)};
    const double per_square_metre = random.uniform(0.001, 0.008);
    const auto landmarks = static_cast<int>(per_square_metre * field_m * field_m);
    const double wall_share = random.uniform(0.0, 0.4);
    for (int i = 0; i < landmarks; ++i) {
        const Point2 place{random.uniform(-field_m / 2.0, field_m / 2.0),
                           random.uniform(-field_m / 2.0, field_m / 2.0)};
        const double size_m = random.uniform() < wall_share ? random.uniform(1.0, 6.0) : 0.0;
        const double thickness_m = random.uniform(0.1, 0.5);
        const double heading_rad = random.uniform(0.0, std::numbers::pi);
        if (distance_to_route(world.route, place) < route_margin_m + size_m / 2.0) {
            continue;
        }
        if (size_m > 0.0) {
            add_box(world, {place.x_m, place.y_m, heading_rad}, size_m, thickness_m);
        } else {
            world.arcs.push_back({.centre = place, .radius_m = thickness_m});
        }
    }
    return world;
}

}  // namespace ddtool::sim
