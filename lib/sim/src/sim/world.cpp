#include "sim/world.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool::sim {
namespace {

Point2 nearest_on(const Segment& segment, const Point2& point) {
    const double dx = segment.b.x_m - segment.a.x_m;
    const double dy = segment.b.y_m - segment.a.y_m;
    const double squared = dx * dx + dy * dy;
    const double along = (point.x_m - segment.a.x_m) * dx + (point.y_m - segment.a.y_m) * dy;
    const double share = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
    return {segment.a.x_m + share * dx, segment.a.y_m + share * dy};
}

}  // namespace

std::vector<Point2> all_way_points(const Route& route) {
    std::vector<Point2> points;
    const auto count = static_cast<std::size_t>(std::lround(route.laps * static_cast<double>(route.way_points.size())));
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(route.way_points[i % route.way_points.size()]);
    }
    return points;
}

Point2 nearest_on_route(const Route& route, const Point2& point) {
    Point2 from{route.start.x_m, route.start.y_m};
    Point2 nearest = from;
    double least_m = std::hypot(from.x_m - point.x_m, from.y_m - point.y_m);
    for (const Point2& to : route.way_points) {
        const Point2 candidate = nearest_on({from, to}, point);
        const double distance_m = std::hypot(candidate.x_m - point.x_m, candidate.y_m - point.y_m);
        if (distance_m < least_m) {
            least_m = distance_m;
            nearest = candidate;
        }
        from = to;
    }
    return nearest;
}

void add_polyline(World& world, const std::vector<Point2>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        world.segments.push_back({points[i - 1], points[i]});
    }
}

void add_box(World& world, const Pose2& world_from_box, double length_m, double width_m) {
    const double x = length_m / 2.0;
    const double y = width_m / 2.0;
    std::vector<Point2> corners;
    for (const Point2& corner : {Point2{-x, -y}, Point2{x, -y}, Point2{x, y}, Point2{-x, y}, Point2{-x, -y}}) {
        corners.push_back(world_from_box * corner);
    }
    add_polyline(world, corners);
}

}  // namespace ddtool::sim
