#pragma once

#include <cmath>

namespace ddtool {

/// The eigenvalues of a symmetric 2 x 2 matrix, and the direction of the eigenvector of the larger one.
struct PrincipalAxes {
    double larger = 0.0;         ///< eigenvalue
    double smaller = 0.0;        ///< eigenvalue; may be slightly negative by rounding if the exact value is 0
    double direction_rad = 0.0;  ///< of the eigenvector of `larger`, in (-pi/2, pi/2]
};

/// The principal axes of the matrix [xx xy; xy yy].
inline PrincipalAxes principal_axes(double xx, double xy, double yy) {
    const double middle = (xx + yy) / 2.0;
    const double radius = std::hypot((xx - yy) / 2.0, xy);
    return {middle + radius, middle - radius, std::atan2(2.0 * xy, xx - yy) / 2.0};
}

}  // namespace ddtool
