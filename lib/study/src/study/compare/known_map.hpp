#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "sim/wheel_odometry.hpp"
#include "study/compare/contestant.hpp"

namespace ddtool::compare {

/// Estimates the trajectory as well as it could be known afterwards by somebody who knows the map: a bound for every
/// SLAM method on the same data, which shows how much of an error is due to the world and the odometry. Works for
/// simulated worlds only.
///
/// Each scan counts as one measurement of the true pose, drawn from a normal distribution with exactly the Fisher
/// information of the scan (sim/fisher_information.hpp). The odometry is used as logged, with the noise that it was
/// simulated with, and with a scale and a gyro bias that are unknown and constant. Both are joined by a
/// Rauch-Tung-Striebel smoother over (x, y, theta, scale, bias), linearised at its own estimates (Rauch, Tung, Striebel
/// 1965, "Maximum likelihood estimates of linear dynamic systems").
class KnownMapEstimator : public Estimator {
public:
    /// truth: provides the Fisher information of the frames that will be processed.
    KnownMapEstimator(const sim::OdometrySettings& odometry, std::uint64_t seed,
                      std::shared_ptr<const ScanTruth> truth);
    /// Throws Error for a frame without a true pose or without Fisher information.
    void process(const SensorFrame& frame) override;
    Trajectory trajectory() override;

private:
    using Vector5 = Eigen::Matrix<double, 5, 1>;
    using Matrix5 = Eigen::Matrix<double, 5, 5>;
    struct Step {
        std::int64_t stamp_ns = 0;
        Vector5 predicted, filtered;
        Matrix5 predicted_covariance, covariance;
        Matrix5 transition;  ///< from the step before
    };

    void predict(const Pose2& motion, double duration_s, Step& step) const;
    void correct(const Pose2& true_pose, const Eigen::Matrix3d& information_in_robot, Step& step);

    sim::OdometrySettings odometry_;
    RandomStream random_;
    std::shared_ptr<const ScanTruth> truth_;
    Pose2 odom_from_robot_;
    std::vector<Step> steps_;
};

}  // namespace ddtool::compare
