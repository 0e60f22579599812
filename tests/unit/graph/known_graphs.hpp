#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "graph/pose_graph.hpp"

namespace ddtool::graph::test {

/// A graph without scale and bias as unknowns.
inline PoseGraph held_calibration() {
    PoseGraph graph;
    graph.calibration.scale_sd = graph.calibration.bias_sd_rad_per_s = 0.0;
    return graph;
}

/// `count` nodes, each a metre of odometry after the one before along x, known to `sigma` in x, y and heading.
inline PoseGraph straight_drive(std::size_t count, double sigma = 0.1) {
    PoseGraph graph = held_calibration();
    graph.poses.emplace_back();
    for (std::size_t node = 1; node < count; ++node) {
        graph.poses.push_back({static_cast<double>(node), 0.0, 0.0});
        graph.odometry.push_back({node - 1, {1.0, 0.0, 0.0}, 1.0, Eigen::Vector3d::Constant(sigma)});
    }
    return graph;
}

inline Pose2 on_ring(std::size_t node, std::size_t count, double radius_m) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(node) / static_cast<double>(count);
    return {radius_m * std::cos(angle), radius_m * std::sin(angle), wrap_angle(angle + std::numbers::pi / 2.0)};
}

/// The true pose of a node of ring_drive(), in the frame of its node 0.
inline Pose2 true_on_ring(std::size_t node, std::size_t count, double radius_m) {
    return between(on_ring(0, count, radius_m), on_ring(node, count, radius_m));
}

/// Twice around a ring, `count` nodes a lap; each step of the odometry turns too far by `turn_error_rad`. The poses are
/// those of the odometry.
inline PoseGraph ring_drive(std::size_t count, double radius_m, double turn_error_rad) {
    PoseGraph graph = held_calibration();
    graph.poses.emplace_back();
    Pose2 step = between(on_ring(0, count, radius_m), on_ring(1, count, radius_m));
    step.theta_rad += turn_error_rad;
    for (std::size_t node = 1; node <= 2 * count; ++node) {
        graph.poses.push_back(graph.poses.back() * step);
        graph.odometry.push_back({node - 1, step, 1.0, {0.02, 0.02, 0.01}});
    }
    return graph;
}

/// An edge that knows `measured` to a centimetre and two milliradians.
inline RelativeEdge sure_edge(std::size_t from, std::size_t to, const Pose2& measured) {
    RelativeEdge edge{.from = from, .to = to, .measured = measured};
    edge.information.diagonal() << 1e4, 1e4, 2.5e5;
    return edge;
}

}  // namespace ddtool::graph::test
