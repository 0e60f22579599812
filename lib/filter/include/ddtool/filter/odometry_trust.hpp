#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

/// The paper's eq. pose_es: phi(c) = -exp(0.7 c) + exp(0.35) + 1, from 1.419 at c = 0 through 1 at 0.5 to 0.405 at 1.
double lidar_trust(double degree);

/// The paper's choice: the lidar's score counts phi(c) times, the odometry's pose keeps its own; the higher wins.
class LidarScoreTrust : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;
};

/// The odometry alone; the match is forgotten.
class OdometryTrust : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;
};

struct EigenvalueGateSettings {
    /// Of the mean end point: the smaller eigenvalue of the match's information about the position, as a share of the
    /// larger, below which the environment counts as degenerate.
    double least_share = 0.02;
};

/// What practitioners do: where the smaller eigenvalue of the match's Hessian is below a threshold, the odometry's pose
/// is taken in its place. It needs no detector.
class EigenvalueGate : public PoseCorrection {
public:
    explicit EigenvalueGate(const EigenvalueGateSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    EigenvalueGateSettings settings_;
};

}  // namespace ddtool
