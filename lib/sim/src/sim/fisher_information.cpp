#include "sim/fisher_information.hpp"

#include <cmath>

namespace ddtool::sim {
namespace {

Eigen::Vector2d rotated(const Point2& vector, double angle_rad) {
    const Point2 turned = Pose2{0.0, 0.0, angle_rad} * vector;
    return {turned.x_m, turned.y_m};
}

/// The derivative of a beam's range with respect to the pose (x, y, theta), all in the robot's frame; the equation is
/// in the header.
Eigen::RowVector3d range_gradient(const Eigen::Vector2d& laser, const Eigen::Vector2d& direction, double range_m,
                                  const Eigen::Vector2d& normal) {
    const Eigen::Vector2d hit = laser + range_m * direction;
    const double turn = normal.y() * hit.x() - normal.x() * hit.y();
    return -Eigen::RowVector3d(normal.x(), normal.y(), turn) / normal.dot(direction);
}

}  // namespace

Eigen::Matrix3d fisher_information(const LaserScan& scan, const BeamHits& hits, const Pose2& world_from_robot,
                                   const Pose2& robot_from_laser, const LidarSettings& settings) {
    const Eigen::Vector2d laser(robot_from_laser.x_m, robot_from_laser.y_m);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (std::size_t beam = 0; beam < hits.size(); ++beam) {
        if (!hits[beam] || hits[beam]->range_m < settings.range_min_m) {
            continue;
        }
        const Hit& hit = *hits[beam];
        const Eigen::Vector2d direction = rotated({1.0, 0.0}, robot_from_laser.theta_rad + scan.angle_rad(beam));
        const Eigen::Vector2d normal = rotated(hit.normal, -world_from_robot.theta_rad);
        const Eigen::RowVector3d gradient = range_gradient(laser, direction, hit.range_m, normal);
        const double sd_m = range_sd_m(settings, hit.range_m);
        information += (1.0 - settings.drop_out_probability) / (sd_m * sd_m) * gradient.transpose() * gradient;
    }
    return information;
}

}  // namespace ddtool::sim
