#include "check/odometry_witness.hpp"

#include <algorithm>
#include <cmath>

#include "base/squared.hpp"
#include "ddtool/filter/scan_matcher.hpp"

namespace ddtool::check {

void OdometryWitness::add(const Update& update) {
    if (update.matched.update == 0 || update.corrected.particles.empty()) {
        return;  // the first update starts the map and has no motion
    }
    const auto& particles = update.corrected.particles;
    const auto best = std::max_element(
        particles.begin(), particles.end(),
        [](const SnapshotParticle& a, const SnapshotParticle& b) { return a.log_likelihood < b.log_likelihood; });
    const Pose2& odometry = update.corrected.odometry_motion;
    const Pose2& matched = best->matched_motion;
    ++sums_.updates;
    const double odometry_m = std::hypot(odometry.x_m, odometry.y_m);
    sums_.odometry_m += odometry_m;
    sums_.matched_m += std::hypot(matched.x_m, matched.y_m);
    sums_.odometry_turn_rad += std::abs(odometry.theta_rad);
    dot_ += odometry.x_m * matched.x_m + odometry.y_m * matched.y_m;
    cross_ += odometry.x_m * matched.y_m - odometry.y_m * matched.x_m;
    squares_ += squared(odometry_m);
    turn_dot_ += odometry.theta_rad * matched.theta_rad;
    turn_squares_ += squared(odometry.theta_rad);
    const double apart_m = std::hypot(matched.x_m - odometry.x_m, matched.y_m - odometry.y_m);
    const double apart_rad = std::abs(wrap_angle(matched.theta_rad - odometry.theta_rad));
    difference2_ += squared(apart_m);
    if (apart_m > 0.3 + 0.5 * odometry_m || apart_rad > 0.3 + 0.5 * std::abs(odometry.theta_rad)) {
        ++sums_.jumps;
    }
    sums_.worst_jump_m = std::max(sums_.worst_jump_m, apart_m);
    sums_.worst_jump_rad = std::max(sums_.worst_jump_rad, apart_rad);
    scores_ += best->match_score;
    sums_.unmatched += best->match_score < ScanMatch::least_score ? 1 : 0;
    sums_.poor += best->match_score < 0.4 ? 1 : 0;
}

OdometryEvidence OdometryWitness::evidence() const {
    OdometryEvidence evidence = sums_;
    if (sums_.updates > 0) {
        evidence.mean_score = scores_ / static_cast<double>(sums_.updates);
        evidence.scatter_m = std::sqrt(difference2_ / static_cast<double>(sums_.updates));
    }
    if (squares_ > 0.0) {
        evidence.along = dot_ / squares_;
        evidence.across = cross_ / squares_;
    }
    if (turn_squares_ > 0.0) {
        evidence.turn = turn_dot_ / turn_squares_;
    }
    return evidence;
}

}  // namespace ddtool::check
