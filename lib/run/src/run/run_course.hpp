#pragma once

#include <vector>

#include "ddtool/filter/update.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "run/worst_moments.hpp"

namespace ddtool {

/// What is kept of an update for tables and pictures: no particles, so that a run of a day has room.
struct UpdateSummary {
    std::int64_t stamp_ns = 0;
    double degree = 0.0;          ///< c in 0..1
    double dispersion = 0.0;      ///< the paper's R, over the accumulated log-likelihoods
    SwarmShape swarm;             ///< of the positions in the world, as matched
    double effective_size = 0.0;  ///< as matched
    double corrected_m = 0.0;     ///< mean distance by which corrections moved the particles
    bool resampled = false;
    Pose2 pose;                                            ///< world_from_robot, as Update has it
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `pose`, as Update has it
    double step_s = 0.0;  ///< wall time in the filter; unlike all else here it differs from run to run
};

UpdateSummary summary_of(const Update& update);

/// What happened update by update, for pictures: of a long run every second update is enough, then every fourth, and so
/// on, so that memory stays bounded.
class RunCourse {
public:
    RunCourse() = default;
    /// Between most / 2 and most updates are kept, once there were as many; an even number.
    explicit RunCourse(std::size_t most) : most_(most) {}

    void add(const Update& update, const UpdateSummary& summary);

    /// `resampled` tells of those left out behind it, too.
    [[nodiscard]] const std::vector<UpdateSummary>& updates() const { return updates_; }
    [[nodiscard]] const WorstMoments& worst() const { return worst_; }

private:
    void halve();

    std::size_t most_ = 1U << 16U;
    std::size_t every_ = 1;  ///< one of so many updates is kept
    std::size_t seen_ = 0;
    std::vector<UpdateSummary> updates_;
    WorstMoments worst_;
};

/// Where the robot was at each update, by the path of the whole run, which has a pose for every scan.
Trajectory places_of(const std::vector<UpdateSummary>& updates, const Trajectory& path);

}  // namespace ddtool
