#include "check/motion_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/squared.hpp"
#include "ddtool/filter/scan_matcher.hpp"

namespace ddtool::check {
namespace {

/// A difference of odometry and match beyond these is no error of wheels: a third of a metre or of a radian, and half
/// of the motion itself, which is as much as wheels slip on ice.
bool is_jump(double apart_m, double apart_rad, const Pose2& odometry) {
    return apart_m > 0.3 + 0.5 * std::hypot(odometry.x_m, odometry.y_m) ||
           apart_rad > 0.3 + 0.5 * std::abs(odometry.theta_rad);
}

/// A corner or a door that holds the scans for less than this does not put right what the wheels erred before.
constexpr double held_again_m = 2.0;

/// Smaller turns between two updates are how a robot that drives straight trembles.
constexpr double least_turn_rad = 0.02;

const SnapshotParticle& best_of(const ParticleSnapshot& swarm) {
    return *std::max_element(
        swarm.particles.begin(), swarm.particles.end(),
        [](const SnapshotParticle& a, const SnapshotParticle& b) { return a.log_likelihood < b.log_likelihood; });
}

/// The median in bins, at the middle of its bin; 0 if nothing was counted.
template <std::size_t Bins>
double median_of(const std::array<std::uint32_t, Bins>& counts) {
    const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::uint64_t below = 0;
    const auto median = std::find_if(counts.begin(), counts.end(), [&](std::uint32_t count) {
        below += count;
        return 2 * below >= all;
    });
    return all == 0 ? 0.0 : static_cast<double>(median - counts.begin()) + 0.5;
}

}  // namespace

void MotionWitness::add(const Update& update, Openness openness) {
    if (update.matched.update == 0 || update.corrected.particles.empty()) {
        first_stamp_ns_ = update.matched.stamp_ns;
        return;
    }
    const SnapshotParticle& best = best_of(update.corrected);
    const Pose2& odometry = update.corrected.odometry_motion;
    const Pose2& matched = best.matched_motion;
    const double odometry_m = std::hypot(odometry.x_m, odometry.y_m);
    ++sums_.updates;
    sums_.odometry_m += odometry_m;
    sums_.matched_m += std::hypot(matched.x_m, matched.y_m);
    const double turn_rad = std::abs(odometry.theta_rad);
    sums_.odometry_turn_rad += turn_rad >= least_turn_rad ? turn_rad : 0.0;
    const double dot = odometry.x_m * matched.x_m + odometry.y_m * matched.y_m;
    dot_ += dot;
    cross_ += odometry.x_m * matched.y_m - odometry.y_m * matched.x_m;
    squares_ += squared(odometry_m);
    turn_dot_ += odometry.theta_rad * matched.theta_rad;
    turn_squares_ += squared(odometry.theta_rad);
    // A robot that turns by a small angle about the point p moves its origin by the angle times (p.y, -p.x).
    lever_.x_m -= odometry.theta_rad * (matched.y_m - odometry.y_m);
    lever_.y_m += odometry.theta_rad * (matched.x_m - odometry.x_m);

    const double apart_m = std::hypot(matched.x_m - odometry.x_m, matched.y_m - odometry.y_m);
    const double apart_rad = std::abs(wrap_angle(matched.theta_rad - odometry.theta_rad));
    ++differences_[std::min(static_cast<std::size_t>(apart_m / step_of_differences_m), differences_.size() - 1)];
    sums_.jumps += is_jump(apart_m, apart_rad, odometry) ? 1 : 0;
    sums_.worst_jump_m = std::max(sums_.worst_jump_m, apart_m);
    sums_.worst_jump_rad = std::max(sums_.worst_jump_rad, apart_rad);
    scores_ += best.match_score;
    const double best_fit =
        std::ranges::max(update.corrected.particles, {}, &SnapshotParticle::match_score).match_score;
    add_fit(update, {.score = best.match_score, .best_particle = best_fit}, openness != Openness::blind);
    sums_.unmatched += openness != Openness::blind && best.match_score < ScanMatch::least_score ? 1 : 0;

    const bool open = openness != Openness::held && before_ != Openness::held;
    if (open && odometry_m > 0.0) {
        add_open(odometry_m, dot / odometry_m, openness == Openness::walls && before_ == Openness::walls);
    } else if (odometry_m > 0.0) {
        stretch_m_ = 0.0;
        stretch_updates_ = 0;
        held_length_m_ += odometry_m;
        open_length_m_ = held_length_m_ < held_again_m ? open_length_m_ : 0.0;
    }
    if (openness == Openness::blind && before_ == Openness::blind) {
        add_blind(odometry_m, wrap_angle(matched.theta_rad - odometry.theta_rad));
    } else {
        blind_turn_rad_ = blind_length_m_ = 0.0;
    }
    before_ = openness;
}

void MotionWitness::add_fit(const Update& update, const Fit& fit, bool sees_surfaces) {
    constexpr ScanMatcherSettings searched;
    const Pose2& odometry = update.corrected.odometry_motion;
    if (sees_surfaces) {
        ++score_counts_[std::min(static_cast<std::size_t>(fit.score / step_of_scores), score_counts_.size() - 1)];
    }
    const double moved_m =
        std::hypot(odometry.x_m, odometry.y_m) + std::hypot(odometry_before_.x_m, odometry_before_.y_m);
    const double turned_rad = std::abs(odometry.theta_rad + odometry_before_.theta_rad);
    if (sees_surfaces && fit_before_ &&
        (moved_m > searched.search_distance_m || turned_rad > searched.search_turn_rad)) {
        const MotionEvidence::Seam seam{.score = std::max(fit.score, fit_before_->score),
                                        .best_particle = std::max(fit.best_particle, fit_before_->best_particle),
                                        .s = 1e-9 * static_cast<double>(update.corrected.stamp_ns - first_stamp_ns_),
                                        .moved_m = moved_m,
                                        .turned_rad = turned_rad};
        sums_.seam = seam.misfit() > sums_.seam.misfit() ? seam : sums_.seam;
    }
    fit_before_ = sees_surfaces ? std::optional(fit) : std::nullopt;
    odometry_before_ = odometry;
}

/// A robot that saw nothing for a while may be put right in one step where it sees something again, so that only steps
/// between walls count alone.
void MotionWitness::add_open(double odometry_m, double along_m, bool between_walls) {
    MotionEvidence::Open& open = sums_.open;
    open.odometry_m += odometry_m;
    open.matched_m += along_m;
    if (between_walls) {
        open.worst_step_m = std::max(open.worst_step_m, std::abs(along_m - odometry_m));
    }
    stretch_m_ += along_m - odometry_m;
    ++stretch_updates_;
    open_length_m_ += odometry_m;
    held_length_m_ = 0.0;
    const double excess_m = std::abs(stretch_m_) - MotionEvidence::wheels_share * open_length_m_;
    if (excess_m > worst_excess_m_) {
        worst_excess_m_ = excess_m;
        open.worst_stretch_m = std::abs(stretch_m_);
        open.worst_length_m = open_length_m_;
        open.worst_updates = stretch_updates_;
    }
}

void MotionWitness::add_blind(double odometry_m, double turn_rad) {
    MotionEvidence::Open& open = sums_.open;
    blind_turn_rad_ += turn_rad;
    blind_length_m_ += odometry_m;
    if (std::abs(blind_turn_rad_) > open.worst_blind_turn_rad) {
        open.worst_blind_turn_rad = std::abs(blind_turn_rad_);
        open.worst_blind_m = blind_length_m_;
    }
}

MotionEvidence MotionWitness::evidence() const {
    MotionEvidence evidence = sums_;
    if (evidence.updates == 0) {
        return evidence;
    }
    evidence.score = scores_ / static_cast<double>(evidence.updates);
    evidence.usual_m = step_of_differences_m * median_of(differences_);
    evidence.usual_score = step_of_scores * median_of(score_counts_);
    if (squares_ > 0.0) {
        evidence.along = dot_ / squares_;
        evidence.across = cross_ / squares_;
    }
    if (turn_squares_ > 0.0) {
        evidence.turn = turn_dot_ / turn_squares_;
        evidence.lever_m = {lever_.x_m / turn_squares_, lever_.y_m / turn_squares_};
    }
    return evidence;
}

}  // namespace ddtool::check
