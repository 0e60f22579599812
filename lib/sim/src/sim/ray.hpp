#pragma once

#include <optional>

#include "ddtool/robot/pose2.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

struct Ray {
    Point2 origin;
    Point2 direction;  ///< unit length
};

Ray ray_at(const Point2& origin, double angle_rad);

struct Hit {
    double range_m = 0.0;
    Point2 normal;     ///< of the surface, unit length, towards the ray's origin
    int surface = -1;  ///< which segment or arc of the world: equal for two hits on the same one
};

/// The first hit of the ray on the surface; nullopt if it misses. Arcs are computed exactly, not as polygons.
std::optional<Hit> intersect(const Ray& ray, const Segment& segment);
std::optional<Hit> intersect(const Ray& ray, const Arc& arc);

}  // namespace ddtool::sim
