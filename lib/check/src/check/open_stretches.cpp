#include "check/open_stretches.hpp"

#include <algorithm>
#include <cmath>

#include "robot/principal_axes.hpp"

namespace ddtool::check {
namespace {

/// Echoes farther apart than this lie on different things.
constexpr double same_surface_m = 0.6;

/// The surfaces' normals of one scan, in the robot's frame.
PrincipalAxes surfaces(const Sight& sight, std::size_t& segments) {
    constexpr std::size_t span = 4;  // over so many beams, so that the noise of the ranges turns the normals little
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    segments = 0;
    for (std::size_t beam = 0; beam + span < sight.beams(); ++beam) {
        if (!std::isfinite(sight.range_m(beam)) || !std::isfinite(sight.range_m(beam + span))) {
            continue;
        }
        const Point2 from = sight.end(beam);
        const Point2 to = sight.end(beam + span);
        const double dx = to.x_m - from.x_m;
        const double dy = to.y_m - from.y_m;
        const double length_m = std::hypot(dx, dy);
        if (length_m > same_surface_m || length_m < 1e-3) {
            continue;
        }
        const double c = std::cos(sight.robot_from_laser().theta_rad);
        const double s = std::sin(sight.robot_from_laser().theta_rad);
        const double nx = -(s * dx + c * dy) / length_m;
        const double ny = (c * dx - s * dy) / length_m;
        xx += nx * nx;
        xy += nx * ny;
        yy += ny * ny;
        ++segments;
    }
    return principal_axes(xx, xy, yy);
}

bool leaves_open(const Sight& sight, const Pose2& motion) {
    std::size_t segments = 0;
    const PrincipalAxes normals = surfaces(sight, segments);
    if (segments < 10) {
        return true;
    }
    const double across = normals.direction_rad;  // the normals point across the corridor
    const double off = std::abs(std::cos(std::atan2(motion.y_m, motion.x_m) - across));
    return normals.smaller < 0.06 * normals.larger && off < 0.35;
}

}  // namespace

OpenStretches open_stretches(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses) {
    OpenStretches sum;
    double stretch_m = 0.0;
    for (std::size_t k = 0; k + 1 < scans.size(); ++k) {
        const Pose2 odometry = between(scans[k].odom_from_robot, scans[k + 1].odom_from_robot);
        const Pose2 path = between(poses[k], poses[k + 1]);
        const double odometry_m = std::hypot(odometry.x_m, odometry.y_m);
        if (odometry_m < 1e-3) {
            continue;
        }
        const double along_m = (odometry.x_m * path.x_m + odometry.y_m * path.y_m) / odometry_m;
        if (leaves_open(scans[k].sight, odometry) && leaves_open(scans[k + 1].sight, odometry)) {
            sum.odometry_m += odometry_m;
            sum.path_m += along_m;
            stretch_m += along_m - odometry_m;
            sum.worst_m = std::max(sum.worst_m, std::abs(stretch_m));
        } else {
            sum.held_odometry_m += odometry_m;
            sum.held_path_m += along_m;
            stretch_m = 0.0;
            sum.held_worst = std::max(sum.held_worst, std::abs(along_m - odometry_m));
        }
    }
    return sum;
}

}  // namespace ddtool::check
