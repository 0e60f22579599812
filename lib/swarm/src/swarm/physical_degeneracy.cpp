#include "swarm/physical_degeneracy.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>

namespace ddtool {
namespace {

/// The information about the position p if the heading t has to be estimated from the same scan, the Schur complement:
///     I_pp - I_pt I_tp / I_tt.
Eigen::Matrix2d of_position(const Eigen::Matrix3d& information) {
    Eigen::Matrix2d position = information.topLeftCorner<2, 2>();
    if (information(2, 2) > 0.0) {
        position -= information.topRightCorner<2, 1>() * information.bottomLeftCorner<1, 2>() / information(2, 2);
    }
    return position;
}

/// An eigenvalue of at most this share of the larger one is a rounding error: the scan does not constrain that
/// direction.
constexpr double least_share = 1e-12;

double sd_of(double information, double largest) {
    return information > least_share * largest ? 1.0 / std::sqrt(information) : std::numeric_limits<double>::infinity();
}

}  // namespace

PhysicalDegeneracy physical_degeneracy(const Eigen::Matrix3d& information, const MotionSigmas& odometry) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(of_position(information));
    const Eigen::Vector2d weak = axes.eigenvectors().col(0);
    const double largest = axes.eigenvalues()(1);
    PhysicalDegeneracy result;
    result.weak_sd_m = sd_of(axes.eigenvalues()(0), largest);
    result.strong_sd_m = sd_of(largest, largest);
    const double angle = std::atan2(weak.y(), weak.x());
    result.weak_direction_rad = std::remainder(angle, std::numbers::pi);
    result.odometry_sd_m = std::hypot(weak.x() * odometry.x_m, weak.y() * odometry.y_m);
    return result;
}

Eigen::Matrix3d information_on_map(const Eigen::Matrix3d& information, double range_sd_m, double cell_size_m) {
    const double beam = range_sd_m * range_sd_m;
    return beam / (beam + cell_size_m * cell_size_m / 12.0) * information;
}

}  // namespace ddtool
