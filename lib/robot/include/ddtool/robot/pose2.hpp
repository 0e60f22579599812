#pragma once

namespace ddtool {

/// A pose in the plane. It is also a transform: named target_from_source, it maps points of the source frame to the
/// target frame, and is the pose of the source frame in the target frame.
struct Pose2 {
    double x_m = 0.0;
    double y_m = 0.0;
    double theta_rad = 0.0;  ///< counter-clockwise

    bool operator==(const Pose2&) const = default;
};

struct Point2 {
    double x_m = 0.0;
    double y_m = 0.0;

    bool operator==(const Point2&) const = default;
};

/// The same angle in [-pi, pi].
double wrap_angle(double angle_rad);

/// a_from_c = a_from_b * b_from_c. The angle is wrapped.
Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);
Point2 operator*(const Pose2& a_from_b, const Point2& point_in_b);

Pose2 inverse(const Pose2& a_from_b);

/// The motion from `from` to `to`, in the frame of `from`: inverse(from) * to.
Pose2 between(const Pose2& from, const Pose2& to);

double distance_m(const Pose2& a, const Pose2& b);

/// A pose between a and b: on the straight line in position, and on the shortest way in angle.
/// \param fraction 0 gives a, 1 gives b
Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction);

}  // namespace ddtool
