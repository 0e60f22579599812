#pragma once

#include <cmath>

namespace ddtool {

/// A symmetric 2 x 2 matrix in its axes.
struct PrincipalAxes {
    double larger = 0.0;         ///< eigenvalue
    double smaller = 0.0;        ///< eigenvalue; rounding may leave it a little below 0 where the matrix has none below
    double direction_rad = 0.0;  ///< of the larger one's eigenvector, in (-pi/2, pi/2]
};

/// Of the matrix [xx xy; xy yy].
inline PrincipalAxes principal_axes(double xx, double xy, double yy) {
    const double middle = (xx + yy) / 2.0;
    const double radius = std::hypot((xx - yy) / 2.0, xy);
    return {middle + radius, middle - radius, std::atan2(2.0 * xy, xx - yy) / 2.0};
}

}  // namespace ddtool
