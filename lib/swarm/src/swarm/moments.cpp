#include "swarm/moments.hpp"

#include <algorithm>
#include <cmath>

#include "robot/principal_axes.hpp"

namespace ddtool {

void PositionMoments::add(const Pose2& at, double weight) {
    if (!std::isfinite(at.x_m) || !std::isfinite(at.y_m) || !(weight > 0.0)) {
        return;
    }
    weight_ += weight;
    squared_weight_ += weight * weight;
    const double dx = at.x_m - mean_.x_m;
    const double dy = at.y_m - mean_.y_m;
    mean_.x_m += weight * dx / weight_;
    mean_.y_m += weight * dy / weight_;
    xx_ += weight * dx * (at.x_m - mean_.x_m);
    xy_ += weight * dx * (at.y_m - mean_.y_m);
    yy_ += weight * dy * (at.y_m - mean_.y_m);
}

double PositionMoments::freedom() const {
    constexpr double least_share = 1e-9;  // share of the sum of the weights; a smaller difference is a rounding error
    const double freedom = weight_ - squared_weight_ / weight_;
    return freedom > least_share * weight_ ? freedom : 0.0;
}

double PositionMoments::covariance(const Point2& first, const Point2& second) const {
    const double divisor = freedom();
    if (divisor == 0.0) {
        return 0.0;
    }
    return (first.x_m * (xx_ * second.x_m + xy_ * second.y_m) + first.y_m * (xy_ * second.x_m + yy_ * second.y_m)) /
           divisor;
}

SwarmShape PositionMoments::shape() const {
    const double divisor = freedom();
    if (divisor == 0.0) {
        return {};
    }
    const PrincipalAxes axes = principal_axes(xx_, xy_, yy_);
    return {axes.larger / divisor, std::max(0.0, axes.smaller) / divisor, axes.direction_rad};
}

Eigen::Matrix3d pose_scatter(std::span<const SnapshotParticle> particles, const Pose2& centre) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const SnapshotParticle& particle : particles) {
        const Eigen::Vector3d apart(particle.pose.x_m - centre.x_m, particle.pose.y_m - centre.y_m,
                                    wrap_angle(particle.pose.theta_rad - centre.theta_rad));
        if (apart.allFinite()) {
            scatter += particle.weight * apart * apart.transpose();
        }
    }
    return scatter;
}

}  // namespace ddtool
