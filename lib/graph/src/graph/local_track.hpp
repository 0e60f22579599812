#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/swarm/motion_model.hpp"
#include "graph/packed_scan.hpp"

namespace ddtool::graph {

/// A scan that entered the filter's map.
struct Node {
    std::int64_t stamp_ns = 0;
    std::size_t scan = 0;  ///< its number among all scans of the run
    Pose2 odom_from_robot;
    double duration_s = 0.0;  ///< since the node before, without pauses
    double degree = 0.0;      ///< the highest degree of degeneracy since the node before
    PackedScan points;
};

/// What matching a node's scan to the map of the last few metres found.
struct LocalStep {
    Pose2 pose;      ///< local_from_robot; drifts, since the map forgets
    Pose2 odometry;  ///< since the node before, as logged
    Pose2 matched;   ///< the motion since the node before that the scan alone gives, where it gives one
    /// About `matched`, in the robot's frame; zero along what the scan does not hold.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double doubt = 1.0;  ///< factor on the odometry's variance where it contradicts the scan
};

struct LocalTrack {
    std::vector<LocalStep> steps;  ///< one for each node
    MotionNoise noise;             ///< of the odometry, as learnt along the way
};

/// Follows the nodes with one hypothesis and a map of the last metres, so that each step tells how the robot moved from
/// node to node and nothing of places seen long before, which loop edges tell. Odometry and match are fused as
/// InformationFusion does; the odometry is learnt as LearntOdometry does.
/// \param path world_from_robot at each node, where matching starts: the filter's result, which has searched with many
///     hypotheses. Only its steps matter.
LocalTrack local_track(const std::vector<Node>& nodes, const std::vector<Pose2>& path, const RbpfSettings& settings);

}  // namespace ddtool::graph
