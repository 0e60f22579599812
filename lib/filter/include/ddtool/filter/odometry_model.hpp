#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>

#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// A motion that both the odometry and the scans have measured.
struct ObservedMotion {
    Pose2 odometry;           ///< as the log has it, in the robot's frame before
    double duration_s = 0.0;  ///< 0 where stamps do not rise
    /// What the scan says of the pose after the motion (x, y, theta in the robot's frame then; 1/m^2, 1/(m rad), ...).
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    /// Pose so many updates ago (0: now) of the particle believed most, after scan matching, or of its ancestor then;
    /// no further back than a thousand updates is certain, then it is the oldest.
    std::function<Pose2(std::size_t)> pose_before;
};

/// What the odometry's motion tells of the true one. It belongs to one filter and is called by one thread at a time.
class OdometryModel {
public:
    virtual ~OdometryModel() = default;
    /// The likeliest motion.
    [[nodiscard]] virtual Pose2 expected(const Pose2& odometry_motion, double duration_s) const = 0;
    /// Its standard deviations, in the robot's frame before.
    [[nodiscard]] virtual MotionSigmas sigmas(const Pose2& odometry_motion, double duration_s) const = 0;
    /// Told of every update, in order.
    virtual void learn(const ObservedMotion& motion) = 0;
};

/// The odometry as it is, with noise that does not change.
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
