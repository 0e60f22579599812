#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>

#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// A motion that was measured by both the odometry and the scans.
struct ObservedMotion {
    Pose2 odometry;           ///< as logged, in the robot's frame before the motion
    double duration_s = 0.0;  ///< 0 where the stamps do not increase
    /// Information that the scan gives about the pose after the motion (x, y, theta in the robot's frame after the
    /// motion; 1/m^2, 1/(m rad), 1/rad^2).
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    /// world_from_robot, after scan matching, of the best particle or its ancestor, the given number of updates ago (0:
    /// now). At least a thousand updates back are available; beyond the oldest pose kept, it returns that one. It may
    /// be called only while learn() runs.
    std::function<Pose2(std::size_t)> pose_before;
};

/// What has been learnt of an odometry, for keeping it beside a map: LearntOdometry says what each is.
struct OdometryState {
    /// A variance per metre or radian: the sum over chords, and their number.
    struct Rate {
        double sum = 0.0;
        double chords = 0.0;
    };
    double scale = 1.0;  ///< true distance divided by the odometry's
    double scale_variance = 0.0;
    double bias_rad_per_s = 0.0;  ///< to be added to the odometry's turn rate
    double bias_variance = 0.0;
    Rate along_per_m, along_per_rad, turn_per_m, turn_per_rad;
};

/// Estimates the true motion from the odometry's. An object belongs to one filter and is called by one thread at a
/// time.
class OdometryModel {
public:
    virtual ~OdometryModel() = default;
    /// The most likely motion, in the robot's frame before the motion.
    [[nodiscard]] virtual Pose2 expected(const Pose2& odometry_motion, double duration_s) const = 0;
    /// Standard deviations of the true motion about expected(), in the robot's frame before the motion.
    [[nodiscard]] virtual MotionSigmas sigmas(const Pose2& odometry_motion, double duration_s) const = 0;
    /// Called once per update after the first, in order.
    virtual void learn(const ObservedMotion& motion) = 0;
    /// What has been learnt so far; empty for a model that learns nothing.
    [[nodiscard]] virtual std::optional<OdometryState> state() const { return std::nullopt; }
};

/// Takes the odometry as it is, with noise that does not change.
class FixedOdometry : public OdometryModel {
public:
    explicit FixedOdometry(const MotionNoise& noise) : noise_(noise) {}
    [[nodiscard]] Pose2 expected(const Pose2& odometry_motion, double /*duration_s*/) const override {
        return odometry_motion;
    }
    [[nodiscard]] MotionSigmas sigmas(const Pose2& odometry_motion, double /*duration_s*/) const override {
        return motion_sigmas(odometry_motion, noise_);
    }
    void learn(const ObservedMotion& /*motion*/) override {}

private:
    MotionNoise noise_;
};

}  // namespace ddtool
