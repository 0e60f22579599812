#include "sim/ray.hpp"

#include <cmath>

namespace ddtool::sim {
namespace {

/// Segments and arcs are longer by this at both ends (as a share of the segment's length, in radians for an arc), so
/// that no ray passes between two of them that share an end.
constexpr double end_slack = 1e-9;

double cross(const Point2& a, const Point2& b) { return a.x_m * b.y_m - a.y_m * b.x_m; }
double dot(const Point2& a, const Point2& b) { return a.x_m * b.x_m + a.y_m * b.y_m; }
Point2 minus(const Point2& a, const Point2& b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }

Hit facing(const Ray& ray, double range_m, const Point2& normal) {
    const double sign = dot(normal, ray.direction) > 0.0 ? -1.0 : 1.0;
    return {.range_m = range_m, .normal = {sign * normal.x_m, sign * normal.y_m}};
}

bool on_arc(const Arc& arc, const Point2& from_centre) {
    const double full = 2.0 * std::numbers::pi;
    if (arc.sweep_rad >= full) {
        return true;
    }
    double turned = std::fmod(std::atan2(from_centre.y_m, from_centre.x_m) - arc.start_rad, full);
    if (turned < -end_slack) {
        turned += full;
    }
    return turned <= arc.sweep_rad + end_slack || turned >= full - end_slack;
}

}  // namespace

Ray ray_at(const Point2& origin, double angle_rad) { return {origin, {std::cos(angle_rad), std::sin(angle_rad)}}; }

std::optional<Hit> intersect(const Ray& ray, const Segment& segment) {
    const Point2 along = minus(segment.b, segment.a);
    const Point2 to_segment = minus(segment.a, ray.origin);
    const double denominator = cross(ray.direction, along);
    const double range_m = cross(to_segment, along) / denominator;
    const double share = cross(to_segment, ray.direction) / denominator;
    if (denominator == 0.0 || !(range_m >= 0.0) || share < -end_slack || share > 1.0 + end_slack) {
        return std::nullopt;
    }
    const double length = std::hypot(along.x_m, along.y_m);
    return facing(ray, range_m, {-along.y_m / length, along.x_m / length});
}

std::optional<Hit> intersect(const Ray& ray, const Arc& arc) {
    const Point2 from_centre = minus(ray.origin, arc.centre);
    const double middle = -dot(from_centre, ray.direction);
    const double discriminant = arc.radius_m * arc.radius_m - dot(from_centre, from_centre) + middle * middle;
    if (discriminant < 0.0) {
        return std::nullopt;
    }
    const double half_chord = std::sqrt(discriminant);
    for (const double range_m : {middle - half_chord, middle + half_chord}) {
        const Point2 radial{from_centre.x_m + range_m * ray.direction.x_m,
                            from_centre.y_m + range_m * ray.direction.y_m};
        if (range_m >= 0.0 && on_arc(arc, radial)) {
            return facing(ray, range_m, {radial.x_m / arc.radius_m, radial.y_m / arc.radius_m});
        }
    }
    return std::nullopt;
}

}  // namespace ddtool::sim
