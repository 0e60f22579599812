#pragma once

#include <vector>

#include "ddtool/filter/update.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "run/worst_moments.hpp"

namespace ddtool {

/// What is kept of one filter update for tables and pictures. The particles are not kept, so that a run of a whole day
/// fits in memory.
struct UpdateSummary {
    std::int64_t stamp_ns = 0;
    double degree = 0.0;          ///< the degree of degeneracy c, in 0..1
    double dispersion = 0.0;      ///< the paper's R, over the accumulated log-likelihoods
    SwarmShape swarm;             ///< of the particles' positions in the world after scan matching
    double effective_size = 0.0;  ///< of the particles after scan matching
    double corrected_m = 0.0;     ///< mean distance by which the correction moved the particles
    bool resampled = false;
    Pose2 pose;                                            ///< world_from_robot, as Update has it
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `pose`, as Update has it
    double step_s = 0.0;  ///< wall time of the update in the filter; the only member that differs between equal runs
};

UpdateSummary summary_of(const Update& update);

/// What happened in a run, update by update, for pictures. As a run becomes longer, only every second update is kept,
/// then every fourth, and so on, so that memory stays bounded.
class RunCourse {
public:
    RunCourse() = default;
    /// `most` is the largest number of updates to keep; it must be even. Once a run has had that many, between most / 2
    /// and most updates are kept.
    explicit RunCourse(std::size_t most) : most_(most) {}

    void add(const Update& update, const UpdateSummary& summary);

    /// The updates that were kept. `resampled` is also true where one of the left-out updates that follow resampled.
    [[nodiscard]] const std::vector<UpdateSummary>& updates() const { return updates_; }
    [[nodiscard]] const WorstMoments& worst() const { return worst_; }

private:
    void halve();

    std::size_t most_ = 1U << 14U;
    std::size_t every_ = 1;  ///< one update of this many is kept
    std::size_t seen_ = 0;
    std::vector<UpdateSummary> updates_;
    WorstMoments worst_;
};

/// Where the robot was at each of the updates, according to the final path of the run, which has a pose for every scan.
Trajectory places_of(const std::vector<UpdateSummary>& updates, const Trajectory& path);

}  // namespace ddtool
