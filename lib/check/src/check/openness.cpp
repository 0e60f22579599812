#include "check/openness.hpp"

#include <cmath>

#include "robot/principal_axes.hpp"

namespace ddtool::check {
namespace {

/// A surface's direction is taken between end points so many beams apart, since the noise of the ranges turns it less
/// than between neighbours. End points farther apart than this are on different things.
constexpr std::size_t span_beams = 4;
constexpr double same_surface_m = 0.6;

/// Fewer pieces of surface hold nothing.
constexpr std::size_t fewest_pieces = 10;
/// The normals of a bare corridor point across it up to the noise of the ranges: the square of a tenth of a radian
/// would be 0.01, doors and people add the rest.
constexpr double open_share = 0.06;
/// The motion goes along the corridor if it is less than 20 degrees off.
constexpr double along_sine = 0.35;

struct Pieces {
    std::size_t count = 0;
    PrincipalAxes normals;  ///< in the robot's frame
};

Pieces pieces_of(const Sight& sight) {
    const double c = std::cos(sight.robot_from_laser().theta_rad);
    const double s = std::sin(sight.robot_from_laser().theta_rad);
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    std::size_t count = 0;
    for (std::size_t beam = 0; beam + span_beams < sight.beams(); ++beam) {
        if (!std::isfinite(sight.range_m(beam)) || !std::isfinite(sight.range_m(beam + span_beams))) {
            continue;
        }
        const Point2 from = sight.end(beam);
        const Point2 to = sight.end(beam + span_beams);
        const double dx = to.x_m - from.x_m;
        const double dy = to.y_m - from.y_m;
        const double length_m = std::hypot(dx, dy);
        if (length_m > same_surface_m || length_m <= 0.0) {
            continue;
        }
        const double normal_x = -(s * dx + c * dy) / length_m;
        const double normal_y = (c * dx - s * dy) / length_m;
        xx += normal_x * normal_x;
        xy += normal_x * normal_y;
        yy += normal_y * normal_y;
        ++count;
    }
    return {count, principal_axes(xx, xy, yy)};
}

}  // namespace

Openness openness_of(const Sight& sight, const Pose2& motion) {
    const Pieces pieces = pieces_of(sight);
    if (pieces.count < fewest_pieces) {
        return Openness::blind;
    }
    const double off = std::abs(std::cos(std::atan2(motion.y_m, motion.x_m) - pieces.normals.direction_rad));
    const bool along = pieces.normals.smaller < open_share * pieces.normals.larger && off < along_sine;
    return along ? Openness::walls : Openness::held;
}

}  // namespace ddtool::check
