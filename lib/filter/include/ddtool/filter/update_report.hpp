#pragma once

#include <Eigen/Core>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/swarm_shape.hpp"

namespace ddtool {

/// What one update of the filter saw of degeneracy and what it did.
struct UpdateReport {
    std::int64_t stamp_ns = 0;
    Degeneracy degeneracy;
    double dispersion = 0.0;   ///< the paper's R, over the accumulated log-likelihoods
    SwarmShape swarm;          ///< of the positions in the world, before the correction
    double corrected_m = 0.0;  ///< mean distance by which strategies moved the matches; 0 where none did
    bool resampled = false;
    Pose2 pose;  ///< world_from_robot, of the best particle
    /// Of the pose (x, y, theta in the world): what the best particle does not know of its place in its map, and how
    /// far the particles' poses are apart.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The report of a swarm as the detector saw it.
UpdateReport report_of(const ParticleSnapshot& seen, const Degeneracy& degeneracy);

/// Weighted covariance of the poses about `centre`, headings as wrapped differences.
Eigen::Matrix3d pose_scatter(const ParticleSnapshot& swarm, const Pose2& centre);

/// Mean distance between the positions of the same particles in both.
double mean_distance_m(const ParticleSnapshot& before, const ParticleSnapshot& after);

}  // namespace ddtool
