#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool::graph {

/// The odometry's motion from node `from` to the next one, as logged.
struct OdometryEdge {
    std::size_t from = 0;
    Pose2 motion;                                      ///< in the frame of `from`
    double duration_s = 0.0;                           ///< how long the gyro's bias acted
    Eigen::Vector3d sigmas = Eigen::Vector3d::Ones();  ///< of x, y and heading, in the frame of `from`
};

/// The pose of node `to` as a match found it relative to node `from`.
struct RelativeEdge {
    std::size_t from = 0;
    std::size_t to = 0;
    Pose2 measured;  ///< from_from_to
    /// About (x, y, theta), in the frame of `to` as measured. It is zero along directions that the match does not hold.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double weight = 1.0;  ///< factor on the information; robust solving sets it for loops
};

/// What is the same for all odometry edges: true motion = (scale * dx, scale * dy, dtheta + bias * duration).
struct OdometryCalibration {
    double scale = 1.0;
    double bias_rad_per_s = 0.0;
    double scale_sd = 0.02;           ///< of the prior about 1; 0: the scale is held
    double bias_sd_rad_per_s = 1e-3;  ///< of the prior about 0; 0: the bias is held
};

/// What all matches get wrong alike: true motion = (1 + stretch) times the matched motion, in x and y.
struct MatchStretch {
    double value = 0.0;
    double sd = 0.0;  ///< of the prior about 0; 0: it is held
};

/// A graph of poses. Node 0 is held where it is. Node k + 1 follows node k in time.
struct PoseGraph {
    std::vector<Pose2> poses;  ///< world_from_robot
    OdometryCalibration calibration;
    MatchStretch match_stretch;
    std::vector<OdometryEdge> odometry;
    std::vector<RelativeEdge> matches;
    std::vector<RelativeEdge> loops;
};

/// The motion of an odometry edge with the calibration applied.
Pose2 calibrated(const OdometryEdge& edge, const OdometryCalibration& calibration);

/// The edge with the calibration applied, as an edge between two poses: its information is in the frame of its end.
RelativeEdge relative_edge(const OdometryEdge& edge, const OdometryCalibration& calibration);

/// The match edge with the stretch applied.
RelativeEdge stretched(RelativeEdge match, const MatchStretch& stretch);

/// An edge's error at two poses and its derivatives by them: e(from + d_from, to + d_to) = error + by_from d_from +
/// by_to d_to to first order, where poses change by adding to x, y and theta.
struct EdgeError {
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    Eigen::Matrix3d by_from = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d by_to = Eigen::Matrix3d::Zero();
};

/// The relative pose of `to`, minus `measured`, in the frame of `measured`'s heading where `in_target_frame`, otherwise
/// in that of `from` (Grisetti et al., "A tutorial on graph-based SLAM", 2010, section IV).
EdgeError edge_error(const Pose2& from, const Pose2& to, const Pose2& measured, bool in_target_frame);

/// The squared error of a relative edge in units of its covariance, without its weight.
double squared_error(const PoseGraph& graph, const RelativeEdge& edge);

}  // namespace ddtool::graph
