#pragma once

#include <Eigen/Core>
#include <span>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/swarm_shape.hpp"

namespace ddtool {

/// Mean and covariance of positions that are added one after the other (West 1979, "Updating mean and variance
/// estimates: an improved method"). No precision is lost by cancellation, however far from the origin the positions
/// are.
class PositionMoments {
public:
    /// Adds a position. Weights need not sum to one. A position that is not finite, or whose weight is not above 0, is
    /// ignored.
    void add(const Pose2& at, double weight = 1.0);

    [[nodiscard]] const Point2& mean() const { return mean_; }
    /// Covariance first^T C second of the positions' components along two directions. C is unbiased: the sum of w (p -
    /// mean)(p - mean)^T divided by W - (sum of w^2) / W, where W is the sum of w. It is zero where one position has
    /// all the weight.
    [[nodiscard]] double covariance(const Point2& first, const Point2& second) const;
    /// C along its principal axes.
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

/// Sum of w d d^T, where d = (x, y, theta) is the difference between a particle's pose and `centre`, the heading as a
/// wrapped difference, and w are the particles' normalised weights. It is the covariance of the poses if `centre` is
/// their mean. Poses that are not finite are ignored.
Eigen::Matrix3d pose_scatter(std::span<const SnapshotParticle> particles, const Pose2& centre);

}  // namespace ddtool
