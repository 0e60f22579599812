#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool::sim {

struct Segment {
    Point2 a;
    Point2 b;
};

/// The part of a circle that starts at start_rad and extends counter-clockwise by sweep_rad; 2 pi is the whole circle.
/// Metres, in the world frame.
struct Arc {
    Point2 centre;
    double radius_m = 1.0;
    double start_rad = 0.0;
    double sweep_rad = 2.0 * std::numbers::pi;
};

/// The route of the robot: from `start` to each way point in turn, through the whole list `laps` times (1.25 laps of
/// four way points are five points). If the list ends at the start, the route is a closed track. Metres, in the world
/// frame.
struct Route {
    Pose2 start;  ///< world_from_robot
    std::vector<Point2> way_points;
    double laps = 1.0;
};

/// Everything that a lidar can see, and the route through it. Coordinates are metres in the frame of the world's file.
struct World {
    std::string name;
    std::string description;
    std::vector<Segment> segments;
    std::vector<Arc> arcs;
    Route route;
};

/// The way points of all laps, in the order they are driven; the start is not among them.
std::vector<Point2> all_way_points(const Route& route);

/// The point of the straight lines between the start and the way points that is nearest to `point`.
Point2 nearest_on_route(const Route& route, const Point2& point);

/// Adds walls along a line through the points. A closed line ends at the point where it begins.
void add_polyline(World& world, const std::vector<Point2>& points);
/// Adds the outline of a box; world_from_box is its centre and heading.
void add_box(World& world, const Pose2& world_from_box, double length_m, double width_m);

}  // namespace ddtool::sim
