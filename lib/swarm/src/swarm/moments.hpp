#pragma once

#include <Eigen/Core>
#include <span>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/swarm_shape.hpp"

namespace ddtool {

/// Mean and covariance of positions, taken in one after the other (West 1979, "Updating mean and variance estimates: an
/// improved method"): nothing cancels, however far from the origin the positions are.
class PositionMoments {
public:
    /// Weights need not sum to one. A position that is not finite, or whose weight is not above 0, does not count.
    void add(const Pose2& at, double weight = 1.0);

    [[nodiscard]] const Point2& mean() const { return mean_; }
    /// Covariance of the positions' components along two directions, first^T C second. C is unbiased, sum of
    /// w (p - mean)(p - mean)^T / (W - (sum of w^2) / W) with W the sum of w; zero where one position has all the
    /// weight.
    [[nodiscard]] double covariance(const Point2& first, const Point2& second) const;
    /// C in its axes.
    [[nodiscard]] SwarmShape shape() const;

private:
    /// The denominator of C; 0 where one position has all the weight, up to rounding.
    [[nodiscard]] double freedom() const;

    double weight_ = 0.0;
    double squared_weight_ = 0.0;
    Point2 mean_;
    double xx_ = 0.0;
    double xy_ = 0.0;
    double yy_ = 0.0;
};

/// Sum of w d d^T, d = (x, y, theta) of a pose less that of `centre`, the heading as a wrapped difference, w the
/// particles' normalised weights: the covariance of the poses where the centre is their mean. Poses that are not finite
/// do not count.
Eigen::Matrix3d pose_scatter(std::span<const SnapshotParticle> particles, const Pose2& centre);

}  // namespace ddtool
