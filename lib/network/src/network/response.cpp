#include "network/response.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

bool is_finite(const SnapshotParticle& particle) {
    return std::isfinite(particle.predicted_motion.x_m) && std::isfinite(particle.predicted_motion.y_m) &&
           std::isfinite(particle.matched_motion.x_m) && std::isfinite(particle.matched_motion.y_m);
}

/// Mean and covariance of one of the particles' motions; Welford's update.
class Spread {
public:
    void include(const Pose2& motion) {
        count_ += 1.0;
        const double dx = motion.x_m - mean_.x_m;
        const double dy = motion.y_m - mean_.y_m;
        mean_.x_m += dx / count_;
        mean_.y_m += dy / count_;
        xx_ += dx * (motion.x_m - mean_.x_m);
        xy_ += dx * (motion.y_m - mean_.y_m);
        yy_ += dy * (motion.y_m - mean_.y_m);
    }

    [[nodiscard]] Point2 deviation(const Pose2& motion) const {
        return {motion.x_m - mean_.x_m, motion.y_m - mean_.y_m};
    }
    [[nodiscard]] double major_angle() const { return 0.5 * std::atan2(2.0 * xy_, xx_ - yy_); }
    /// Covariance of the deviations' components along two directions.
    [[nodiscard]] double covariance(const Point2& first, const Point2& second) const {
        const double sum =
            first.x_m * (xx_ * second.x_m + xy_ * second.y_m) + first.y_m * (xy_ * second.x_m + yy_ * second.y_m);
        return sum / std::max(1.0, count_ - 1.0);
    }

private:
    double count_ = 0.0;
    Point2 mean_;
    double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

double dot(const Point2& a, const Point2& b) { return a.x_m * b.x_m + a.y_m * b.y_m; }

/// The covector of the direction in which the matched spread is widest, both measured in predicted spreads: applied to
/// a deviation in metres it gives how many of them that is.
Point2 weakest_direction(const Spread& predicted, const Spread& matched, double least_spread_m) {
    const double angle = predicted.major_angle();
    const Point2 major{std::cos(angle), std::sin(angle)};
    const Point2 minor{-major.y_m, major.x_m};
    const auto per_spread = [&](const Point2& axis) {
        const double spread_m = std::max(least_spread_m, std::sqrt(std::max(0.0, predicted.covariance(axis, axis))));
        return Point2{axis.x_m / spread_m, axis.y_m / spread_m};
    };
    const Point2 a = per_spread(major);
    const Point2 b = per_spread(minor);
    const double widest =
        0.5 * std::atan2(2.0 * matched.covariance(a, b), matched.covariance(a, a) - matched.covariance(b, b));
    const double cosine = std::cos(widest);
    const double sine = std::sin(widest);
    return {cosine * a.x_m + sine * b.x_m, cosine * a.y_m + sine * b.y_m};
}

}  // namespace

void response(std::span<const SnapshotParticle> particles, double least_spread_m, std::vector<Point2>& points) {
    Spread predicted;
    Spread matched;
    for (const SnapshotParticle& particle : particles) {
        if (is_finite(particle)) {
            predicted.include(particle.predicted_motion);
            matched.include(particle.matched_motion);
        }
    }
    const Point2 direction = weakest_direction(predicted, matched, least_spread_m);
    points.clear();
    for (const SnapshotParticle& particle : particles) {
        if (is_finite(particle)) {
            points.push_back({dot(direction, predicted.deviation(particle.predicted_motion)),
                              dot(direction, matched.deviation(particle.matched_motion))});
        }
    }
}

}  // namespace ddtool
