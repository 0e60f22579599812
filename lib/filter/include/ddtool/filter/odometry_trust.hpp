#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

/// The factor on the lidar's score in the paper's eq. pose_es: phi(c) = -exp(0.7 c) + exp(0.35) + 1. It falls from
/// 1.419 at c = 0 through 1 at c = 0.5 to 0.405 at c = 1.
double lidar_trust(double degree);

/// The paper's choice between match and odometry: the score of the match is multiplied by phi(c), the score at the
/// odometry's pose is not, and the pose with the higher result is used.
class LidarScoreTrust : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;
};

/// Uses the odometry's pose always and discards the match.
class OdometryTrust : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;
};

struct EigenvalueGateSettings {
    /// Threshold on the ratio of the smaller to the larger eigenvalue of the match's information about the position. At
    /// or below it, the environment counts as degenerate.
    double least_share = 0.02;
};

/// The common practice: where the smaller eigenvalue of the match's Hessian is too small in proportion to the larger,
/// or the match was not accepted, the odometry's pose is used instead. It needs no detector.
class EigenvalueGate : public PoseCorrection {
public:
    explicit EigenvalueGate(const EigenvalueGateSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    EigenvalueGateSettings settings_;
};

}  // namespace ddtool
