#include "network/response.hpp"

#include <algorithm>
#include <cmath>

#include "swarm/moments.hpp"

namespace ddtool {
namespace {

bool is_finite_particle(const SnapshotParticle& particle) {
    return std::isfinite(particle.predicted_motion.x_m) && std::isfinite(particle.predicted_motion.y_m) &&
           std::isfinite(particle.matched_motion.x_m) && std::isfinite(particle.matched_motion.y_m);
}

/// The deviation of a motion's position from the mean of all motions, in metres.
Point2 deviation(const Pose2& motion, const PositionMoments& all) {
    return {motion.x_m - all.mean().x_m, motion.y_m - all.mean().y_m};
}

double dot(const Point2& a, const Point2& b) { return a.x_m * b.x_m + a.y_m * b.y_m; }

/// The direction in which the matched spread is widest, when both axes are measured in predicted standard deviations.
/// It is returned as a covector: its dot product with a deviation in metres is the deviation along that direction, in
/// predicted standard deviations.
Point2 weakest_direction(const PositionMoments& predicted, const PositionMoments& matched, double least_spread_m) {
    const double angle = predicted.shape().major_direction_rad;
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
    PositionMoments predicted;
    PositionMoments matched;
    for (const SnapshotParticle& particle : particles) {
        if (is_finite_particle(particle)) {
            predicted.add(particle.predicted_motion);
            matched.add(particle.matched_motion);
        }
    }
    const Point2 direction = weakest_direction(predicted, matched, least_spread_m);
    points.clear();
    for (const SnapshotParticle& particle : particles) {
        if (is_finite_particle(particle)) {
            points.push_back({dot(direction, deviation(particle.predicted_motion, predicted)),
                              dot(direction, deviation(particle.matched_motion, matched))});
        }
    }
}

}  // namespace ddtool
