#include "ddtool/robot/pose2.hpp"

#include <cmath>
#include <numbers>

namespace ddtool {

double wrap_angle(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

Point2 operator*(const Pose2& a_from_b, const Point2& point_in_b) {
    const double c = std::cos(a_from_b.theta_rad);
    const double s = std::sin(a_from_b.theta_rad);
    return {a_from_b.x_m + c * point_in_b.x_m - s * point_in_b.y_m,
            a_from_b.y_m + s * point_in_b.x_m + c * point_in_b.y_m};
}

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
    const Point2 position = a_from_b * Point2{b_from_c.x_m, b_from_c.y_m};
    return {position.x_m, position.y_m, wrap_angle(a_from_b.theta_rad + b_from_c.theta_rad)};
}

Pose2 inverse(const Pose2& a_from_b) {
    const Point2 position = Pose2{0.0, 0.0, -a_from_b.theta_rad} * Point2{-a_from_b.x_m, -a_from_b.y_m};
    return {position.x_m, position.y_m, wrap_angle(-a_from_b.theta_rad)};
}

Pose2 between(const Pose2& from, const Pose2& to) { return inverse(from) * to; }

double distance_m(const Pose2& a, const Pose2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction) {
    return {a.x_m + fraction * (b.x_m - a.x_m), a.y_m + fraction * (b.y_m - a.y_m),
            wrap_angle(a.theta_rad + fraction * wrap_angle(b.theta_rad - a.theta_rad))};
}

}  // namespace ddtool
