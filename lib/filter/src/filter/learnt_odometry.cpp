#include "ddtool/filter/learnt_odometry.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/squared.hpp"

namespace ddtool {
namespace {

double length_m(const Pose2& motion) { return std::hypot(motion.x_m, motion.y_m); }

/// Standard deviations of the pose in the robot's x direction and of its heading, as far as the scan alone determines
/// them. A unit of information is added in every direction, so that a deviation is at most 1 m or 1 rad.
struct ObservedSds {
    double along_m = 0.0;
    double heading_rad = 0.0;
};

ObservedSds sds_of(const Eigen::Matrix3d& information) {
    const Eigen::Matrix3d covariance = (information + Eigen::Matrix3d::Identity()).inverse();
    return {std::sqrt(covariance(0, 0)), std::sqrt(covariance(2, 2))};
}

/// The filter adds up the variances of its steps as if their errors were independent. An error that stays the same
/// during a run, such as that of the scale or the gyro's bias, grows faster: its deviation grows in proportion to the
/// distance or the time, not to the square root. Its variance per step is therefore chosen so that the sum is right
/// over this distance or time.
constexpr double constant_error_horizon_m = 10.0;
constexpr double constant_error_horizon_s = 10.0;

/// A residual of more standard deviations than this comes from a slip or a wrong match. Its variance is then increased
/// until the residual is exactly this many deviations, and the noise is learnt as from a residual of that size.
constexpr double most_deviations = 3.0;

/// Chords that turn more than this are not used to learn the scale.
constexpr double straight_rad = 0.3;

}  // namespace

/// The correction of a Kalman filter with one state, which is measured as value = gain * state + noise.
void LearntOdometry::Estimate::correct(double value, double gain, double noise_variance) {
    const double residual = value - gain * mean;
    double innovation = gain * gain * variance + noise_variance;
    innovation *= std::max(1.0, residual * residual / (squared(most_deviations) * innovation));
    const double weight = variance * gain / innovation;
    mean += weight * residual;
    variance *= 1.0 - weight * gain;
}

void LearntOdometry::NoiseRate::add(double ratio, double share, double most_chords) {
    const double kept = std::min(1.0, most_chords / chords);
    sum = kept * sum + share * ratio * rate();
    chords = kept * chords + share;
}

LearntOdometry::LearntOdometry()
    : scale_{0.0, squared(OdometryLearning::scale_sd)}, bias_{0.0, squared(OdometryLearning::bias_sd_rad_per_s)} {
    const auto assumed = [](double per_root) {
        return NoiseRate{OdometryLearning::noise_chords * squared(per_root), OdometryLearning::noise_chords};
    };
    along_per_m_ = assumed(OdometryLearning::noise.translation_per_translation);
    along_per_rad_ = assumed(OdometryLearning::noise.translation_per_rotation);
    turn_per_m_ = assumed(OdometryLearning::noise.rotation_per_translation);
    turn_per_rad_ = assumed(OdometryLearning::noise.rotation_per_rotation);
}

LearntOdometry::LearntOdometry(const OdometryState& state)
    : scale_{state.scale - 1.0, state.scale_variance},
      bias_{state.bias_rad_per_s, state.bias_variance},
      along_per_m_{state.along_per_m.sum, state.along_per_m.chords},
      along_per_rad_{state.along_per_rad.sum, state.along_per_rad.chords},
      turn_per_m_{state.turn_per_m.sum, state.turn_per_m.chords},
      turn_per_rad_{state.turn_per_rad.sum, state.turn_per_rad.chords} {}

std::optional<OdometryState> LearntOdometry::state() const {
    const auto rate = [](const NoiseRate& of) { return OdometryState::Rate{of.sum, of.chords}; };
    return OdometryState{.scale = scale(),
                         .scale_variance = scale_.variance,
                         .bias_rad_per_s = bias_.mean,
                         .bias_variance = bias_.variance,
                         .along_per_m = rate(along_per_m_),
                         .along_per_rad = rate(along_per_rad_),
                         .turn_per_m = rate(turn_per_m_),
                         .turn_per_rad = rate(turn_per_rad_)};
}

double LearntOdometry::scale_sd() const { return std::sqrt(scale_.variance); }

MotionNoise LearntOdometry::noise() const {
    return {std::sqrt(along_per_m_.rate()), std::sqrt(along_per_rad_.rate()), std::sqrt(turn_per_m_.rate()),
            std::sqrt(turn_per_rad_.rate())};
}

double LearntOdometry::along_variance(double way_m, double turn_rad) const {
    return along_per_m_.rate() * way_m + along_per_rad_.rate() * turn_rad;
}

double LearntOdometry::turn_variance(double way_m, double turn_rad) const {
    return turn_per_m_.rate() * way_m + turn_per_rad_.rate() * turn_rad;
}

Pose2 LearntOdometry::expected(const Pose2& odometry_motion, double duration_s) const {
    return {scale() * odometry_motion.x_m, scale() * odometry_motion.y_m,
            wrap_angle(odometry_motion.theta_rad + bias_.mean * duration_s)};
}

MotionSigmas LearntOdometry::sigmas(const Pose2& odometry_motion, double duration_s) const {
    const MotionSigmas random = motion_sigmas(odometry_motion, noise());
    const double scale_variance = scale_.variance * constant_error_horizon_m * length_m(odometry_motion);
    const double bias_variance = bias_.variance * constant_error_horizon_s * duration_s;
    return {OdometryLearning::caution * std::sqrt(squared(random.x_m) + scale_variance),
            OdometryLearning::caution * std::sqrt(squared(random.y_m)),
            OdometryLearning::caution * std::sqrt(squared(random.theta_rad) + bias_variance)};
}

void LearntOdometry::learn(const ObservedMotion& motion) {
    const ObservedSds sds = sds_of(motion.information);
    chord_.odometry = chord_.odometry * motion.odometry;
    ++chord_.updates;
    chord_.way_m += length_m(motion.odometry);
    chord_.turn_rad += std::abs(motion.odometry.theta_rad);
    chord_.duration_s += motion.duration_s;
    chord_.along_sd_m = std::max(chord_.along_sd_m, sds.along_m);
    chord_.heading_sd_rad = std::max(chord_.heading_sd_rad, sds.heading_rad);
    if (chord_.way_m < OdometryLearning::chord_m && chord_.turn_rad < OdometryLearning::chord_turn_rad) {
        return;
    }
    chord_.matched = between(motion.pose_before(chord_.updates), motion.pose_before(0));
    learn_scale();
    learn_turn();
    chord_ = {};
}

void LearntOdometry::learn_scale() {
    if (chord_.along_sd_m > OdometryLearning::observed_sd_m || chord_.turn_rad > straight_rad) {
        return;
    }
    const double length = chord_.odometry.x_m;
    const double residual = chord_.matched.x_m - length;
    const double variance = along_variance(chord_.way_m, chord_.turn_rad);
    const double ratio = std::min(squared(residual - scale_.mean * length) / variance, squared(most_deviations));
    const double way_share = along_per_m_.rate() * chord_.way_m / variance;
    scale_.correct(residual, length, variance);
    along_per_m_.add(ratio, way_share, OdometryLearning::remembered_chords);
    along_per_rad_.add(ratio, 1.0 - way_share, OdometryLearning::remembered_chords);
}

void LearntOdometry::learn_turn() {
    if (chord_.heading_sd_rad > OdometryLearning::observed_sd_rad) {
        return;
    }
    const double residual = wrap_angle(chord_.matched.theta_rad - chord_.odometry.theta_rad);
    const double variance = turn_variance(chord_.way_m, chord_.turn_rad);
    const double ratio =
        std::min(squared(residual - bias_.mean * chord_.duration_s) / variance, squared(most_deviations));
    const double way_share = turn_per_m_.rate() * chord_.way_m / variance;
    bias_.correct(residual, chord_.duration_s, variance);
    turn_per_m_.add(ratio, way_share, OdometryLearning::remembered_chords);
    turn_per_rad_.add(ratio, 1.0 - way_share, OdometryLearning::remembered_chords);
}

}  // namespace ddtool
