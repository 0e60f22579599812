#pragma once

#include <Eigen/Core>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/swarm/motion_model.hpp"
#include "graph/node.hpp"

namespace ddtool::graph {

/// One step of the filter's path, from the node before to a node, and what can be believed of it.
struct PathStep {
    Pose2 pose;      ///< world_from_robot at the node, by the filter
    Pose2 odometry;  ///< motion since the node before, as logged
    /// About `pose` relative to the nodes before it (x, y, theta in the world): what the scan says in a map of the last
    /// metres. Zero along what the scan does not hold, and as little as the step is wrong where it is doubtful.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double doubt = 1.0;  ///< factor on the odometry's variance where it contradicts the step
};

struct PathSteps {
    std::vector<PathStep> steps;  ///< one for each node
    MotionNoise noise;            ///< of the odometry, as learnt along the way
};

/// Goes along the filter's path and judges its steps, each by a map that the last metres of the path have drawn. The
/// filter has found the path with many hypotheses and wide searches, and a single one that matches scan after scan
/// loses its way where the filter did not; so the path itself is the measurement, and only its information is found
/// here.
///
/// Where the filter closes a loop, its path leaps: the new pose fits the map of long ago, not the last metres. Such a
/// step is no motion of the robot. It contradicts the odometry, and the map of the last metres does not bear it out:
/// the scan fits the map nearly as well where the odometry says, or much less than scans usually do, or better
/// somewhere else. The step's information is then lowered along the contradiction d, so that its covariance grows by d
/// d'.
///
/// \param path world_from_robot at each node
PathSteps path_steps(const std::vector<Node>& nodes, const std::vector<Pose2>& path, const RbpfSettings& settings);

}  // namespace ddtool::graph
