#include "sim/world.hpp"

#include <cmath>

namespace ddtool::sim {

std::vector<Point2> all_way_points(const Route& route) {
    std::vector<Point2> points;
    const auto count = static_cast<std::size_t>(std::lround(route.laps * static_cast<double>(route.way_points.size())));
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(route.way_points[i % route.way_points.size()]);
    }
    return points;
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
