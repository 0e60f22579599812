#include "robot/scan_information.hpp"

namespace ddtool {
namespace {

/// From this along_weight on, the neighbours of a point form no line, and the point determines the position in both
/// directions.
constexpr float no_line = 0.5F;

/// The information about the pose (x, y, theta) from an end point whose position is known along `direction` with unit
/// variance: the outer product of the derivative of the end point's coordinate along `direction` with respect to the
/// pose.
Eigen::Matrix3d held_along(const Eigen::Vector2d& direction, const Eigen::Vector2d& end) {
    const Eigen::Vector3d gradient(direction.x(), direction.y(), direction.y() * end.x() - direction.x() * end.y());
    return gradient * gradient.transpose();
}

}  // namespace

Eigen::Matrix3d scan_information(const ScanPoints& points, double point_sd_m) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d end = Eigen::Vector2f(points.x_m[i], points.y_m[i]).cast<double>();
        const Eigen::Vector2d normal = Eigen::Vector2f(points.normal_x[i], points.normal_y[i]).cast<double>();
        sum += held_along(normal, end);
        if (points.along_weight[i] >= no_line) {
            sum += held_along({-normal.y(), normal.x()}, end);
        }
    }
    return sum / (point_sd_m * point_sd_m);
}

}  // namespace ddtool
