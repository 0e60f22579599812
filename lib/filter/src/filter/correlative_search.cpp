#include "ddtool/filter/correlative_search.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace ddtool {
namespace {

/// The axes of the lattice as unit vectors in the world frame. `weak` is the direction that the scan constrains less;
/// weak_steps is 0 where the scan is degenerate, so that this direction is not searched.
struct LatticeAxes {
    Eigen::Vector2d strong;
    Eigen::Vector2d weak;
    int weak_steps = 0;
};

/// Returns the pose with the highest score on a lattice around `centre`, whose poses are step_m and step_rad apart.
Pose2 best_on_lattice(const MatchContext& context, const LatticeAxes& axes, const Pose2& centre, int steps,
                      double step_m, double step_rad) {
    Pose2 best = centre;
    double best_score = context.matcher.score(context.grid, context.points, centre, search_stride);
    for (int turn = -steps; turn <= steps; ++turn) {
        for (int across = -steps; across <= steps; ++across) {
            for (int along = -axes.weak_steps; along <= axes.weak_steps; ++along) {
                const Eigen::Vector2d shift = step_m * (across * axes.strong + along * axes.weak);
                const Pose2 pose{centre.x_m + shift.x(), centre.y_m + shift.y(),
                                 wrap_angle(centre.theta_rad + turn * step_rad)};
                const double score = context.matcher.score(context.grid, context.points, pose, search_stride);
                if (score > best_score) {
                    best_score = score;
                    best = pose;
                }
            }
        }
    }
    return best;
}

}  // namespace

Eigen::Matrix2d normal_scatter(const MatchPoints& points, double theta_rad) {
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    double total = 0.0;
    for (std::size_t beam = 0; beam < points.beams; ++beam) {
        const double weight = 1.0 - static_cast<double>(points.along_weight[beam]);
        const Eigen::Vector2d normal(points.normal_x[beam], points.normal_y[beam]);
        scatter += weight * normal * normal.transpose();
        total += weight;
    }
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(theta_rad).toRotationMatrix();
    return total > 0.0 ? Eigen::Matrix2d(turn * scatter * turn.transpose() / total) : scatter;
}

ScanMatch CorrelativeSearch::correct(const MatchContext& context, const ScanMatch& /*found*/) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> components(
        normal_scatter(context.points, context.odometry.theta_rad));
    const bool degenerate = components.eigenvalues()(0) <= settings_.degenerate_share * components.eigenvalues()(1);
    const LatticeAxes axes{components.eigenvectors().col(1), components.eigenvectors().col(0),
                           degenerate ? 0 : settings_.steps};
    Pose2 best = context.odometry;
    double window = 1.0;
    for (int level = 0; level < settings_.levels; ++level) {
        window /= settings_.steps;
        best = best_on_lattice(context, axes, best, settings_.steps, window * settings_.window_m,
                               window * settings_.window_rad);
    }
    return context.matcher.evaluate(context.grid, context.points, best);
}

}  // namespace ddtool
