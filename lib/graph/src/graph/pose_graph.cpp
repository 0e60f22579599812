#include "graph/pose_graph.hpp"

#include <cmath>

#include "filter/pose_covariance.hpp"

namespace ddtool::graph {

Pose2 calibrated(const OdometryEdge& edge, const OdometryCalibration& calibration) {
    return {calibration.scale * edge.motion.x_m, calibration.scale * edge.motion.y_m,
            wrap_angle(edge.motion.theta_rad + calibration.bias_rad_per_s * edge.duration_s)};
}

RelativeEdge relative_edge(const OdometryEdge& edge, const OdometryCalibration& calibration) {
    const Pose2 motion = calibrated(edge, calibration);
    const Eigen::Matrix3d along = edge.sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
    const Eigen::Matrix3d turned = turned_about_z(-motion.theta_rad);
    return {
        .from = edge.from, .to = edge.from + 1, .measured = motion, .information = turned * along * turned.transpose()};
}

RelativeEdge stretched(RelativeEdge match, const MatchStretch& stretch) {
    match.measured.x_m *= 1.0 + stretch.value;
    match.measured.y_m *= 1.0 + stretch.value;
    return match;
}

EdgeError edge_error(const Pose2& from, const Pose2& to, const Pose2& measured, bool in_target_frame) {
    const double c = std::cos(from.theta_rad);
    const double s = std::sin(from.theta_rad);
    const double dx = to.x_m - from.x_m;
    const double dy = to.y_m - from.y_m;
    EdgeError result;
    result.error << c * dx + s * dy - measured.x_m, -s * dx + c * dy - measured.y_m,
        wrap_angle(to.theta_rad - from.theta_rad - measured.theta_rad);
    result.by_from << -c, -s, -s * dx + c * dy,  //
        s, -c, -c * dx - s * dy,                 //
        0.0, 0.0, -1.0;
    result.by_to << c, s, 0.0,  //
        -s, c, 0.0,             //
        0.0, 0.0, 1.0;
    if (in_target_frame) {
        const Eigen::Matrix3d turned = turned_about_z(-measured.theta_rad);
        result.error = turned * result.error;
        result.by_from = turned * result.by_from;
        result.by_to = turned * result.by_to;
    }
    return result;
}

double squared_error(const PoseGraph& graph, const RelativeEdge& edge) {
    const Eigen::Vector3d error = edge_error(graph.poses[edge.from], graph.poses[edge.to], edge.measured, true).error;
    return error.dot(edge.information * error);
}

}  // namespace ddtool::graph
