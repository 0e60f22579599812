#include "swarm/spread.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// Sums for a weighted covariance, one particle after the other (West 1979), without cancellation.
class CovarianceSums {
public:
    void add(const Pose2& at, double weight) {
        if (!std::isfinite(at.x_m) || !std::isfinite(at.y_m) || !(weight > 0.0)) {
            return;
        }
        weight_ += weight;
        squared_weight_ += weight * weight;
        const double dx = at.x_m - mean_x_;
        const double dy = at.y_m - mean_y_;
        mean_x_ += weight * dx / weight_;
        mean_y_ += weight * dy / weight_;
        xx_ += weight * dx * (at.x_m - mean_x_);
        xy_ += weight * dx * (at.y_m - mean_y_);
        yy_ += weight * dy * (at.y_m - mean_y_);
    }

    [[nodiscard]] PositionSpread spread() const {
        const double freedom = weight_ - squared_weight_ / weight_;
        if (!(freedom > 0.0)) {
            return {};
        }
        const double middle = (xx_ + yy_) / 2.0;
        const double radius = std::hypot((xx_ - yy_) / 2.0, xy_);
        return {std::sqrt((middle + radius) / freedom), std::sqrt(std::max(0.0, middle - radius) / freedom)};
    }

private:
    double weight_ = 0.0;
    double squared_weight_ = 0.0;
    double mean_x_ = 0.0;
    double mean_y_ = 0.0;
    double xx_ = 0.0;
    double xy_ = 0.0;
    double yy_ = 0.0;
};

}  // namespace

PositionSpread position_spread(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    CovarianceSums sums;
    for (const SnapshotParticle& particle : particles) {
        sums.add(particle.*position, 1.0);
    }
    return sums.spread();
}

PositionSpread weighted_position_spread(std::span<const SnapshotParticle> particles,
                                        Pose2 SnapshotParticle::*position) {
    CovarianceSums sums;
    for (const SnapshotParticle& particle : particles) {
        sums.add(particle.*position, particle.weight);
    }
    return sums.spread();
}

double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    return position_spread(particles, position).major_m;
}

double step_spread_ratio(std::span<const SnapshotParticle> particles) {
    const double predicted_m = spread_m(particles, &SnapshotParticle::predicted_motion);
    return predicted_m > 0.0 ? spread_m(particles, &SnapshotParticle::matched_motion) / predicted_m : 0.0;
}

}  // namespace ddtool
