#include "sim/texture.hpp"

#include <cmath>

#include "ddtool/base/random.hpp"
#include "sim/random_purpose.hpp"

namespace ddtool::sim {
namespace {

/// Shorter walls stay smooth.
constexpr double shortest_wall_m = 2.0;
/// Features keep this distance from the ends of a wall.
constexpr double corner_margin_m = 0.5;
constexpr std::size_t outline_points = 24;

/// A feature of a wall: its width, and how far it stands out (negative for a recess).
struct Feature {
    double width_m;
    double height_m;
};

Feature draw_feature(RandomStream& random) {
    const double kind = random.uniform();
    if (kind < 0.4) {
        return {random.uniform(0.85, 1.1), -random.uniform(0.08, 0.15)};
    }
    if (kind < 0.75) {
        return {random.uniform(1.0, 3.0), 0.015};
    }
    return {random.uniform(0.2, 0.45), random.uniform(0.08, 0.15)};
}

/// A wall and its frame: x runs along the wall from the first end; the route is on the side of positive or negative y.
struct Wall {
    Pose2 world_from_wall;
    double length_m;
    double route_side;  ///< +1 or -1: the sign of y where the route is

    // The point at along_m along the wall that is out_m in front of it, as seen from the route.
    [[nodiscard]] Point2 at(double along_m, double out_m) const {
        return world_from_wall * Point2{along_m, route_side * out_m};
    }
};

Wall wall_of(const Segment& segment, const Route& route) {
    const double dx = segment.b.x_m - segment.a.x_m;
    const double dy = segment.b.y_m - segment.a.y_m;
    const Pose2 world_from_wall{segment.a.x_m, segment.a.y_m, std::atan2(dy, dx)};
    const Point2 middle{(segment.a.x_m + segment.b.x_m) / 2.0, (segment.a.y_m + segment.b.y_m) / 2.0};
    const Point2 driven = inverse(world_from_wall) * nearest_on_route(route, middle);
    return {world_from_wall, std::hypot(dx, dy), driven.y_m < 0.0 ? -1.0 : 1.0};
}

void add_textured_wall(World& world, const Wall& wall, RandomStream& random) {
    std::vector<Point2> line{wall.at(0.0, 0.0)};
    double along_m = corner_margin_m + random.uniform(0.0, 2.0);
    while (true) {
        const Feature feature = draw_feature(random);
        const double end_m = along_m + feature.width_m;
        if (end_m > wall.length_m - corner_margin_m) {
            break;
        }
        line.push_back(wall.at(along_m, 0.0));
        line.push_back(wall.at(along_m, feature.height_m));
        line.push_back(wall.at(end_m, feature.height_m));
        line.push_back(wall.at(end_m, 0.0));
        along_m = end_m + random.uniform(0.3, 5.0);
    }
    line.push_back(wall.at(wall.length_m, 0.0));
    add_polyline(world, line);
}

void add_rough_circle(World& world, const Arc& circle, RandomStream& random) {
    std::vector<Point2> outline;
    for (std::size_t i = 0; i < outline_points; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(i) / outline_points;
        const double radius_m = circle.radius_m * random.uniform(0.85, 1.0);
        outline.push_back(
            {circle.centre.x_m + radius_m * std::cos(angle_rad), circle.centre.y_m + radius_m * std::sin(angle_rad)});
    }
    outline.push_back(outline.front());
    add_polyline(world, outline);
}

}  // namespace

World textured(const World& world) {
    RandomStream random({0, texture_layout});
    World result{.name = world.name + "-textured",
                 .description = world.description + ", textured",
                 .segments = {},
                 .arcs = {},
                 .route = world.route};
    for (const Segment& segment : world.segments) {
        const Wall wall = wall_of(segment, world.route);
        if (wall.length_m < shortest_wall_m) {
            result.segments.push_back(segment);
        } else {
            add_textured_wall(result, wall, random);
        }
    }
    for (const Arc& arc : world.arcs) {
        if (arc.sweep_rad < 2.0 * std::numbers::pi - 1e-9) {
            result.arcs.push_back(arc);
        } else {
            add_rough_circle(result, arc, random);
        }
    }
    return result;
}

}  // namespace ddtool::sim
