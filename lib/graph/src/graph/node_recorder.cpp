#include "graph/node_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool::graph {
namespace {

/// A longer time between two scans is a pause in the log, in which the gyro's bias did not act on the odometry.
constexpr double longest_step_s = 2.0;

}  // namespace

std::optional<Node> NodeRecorder::add(const SensorFrame& frame, const std::optional<Update>& update) {
    const std::size_t scan = scans_++;
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    if (scan > 0) {
        duration_s_ += std::clamp(1e-9 * static_cast<double>(stamp_ns - stamp_ns_), 0.0, longest_step_s);
    }
    stamp_ns_ = stamp_ns;
    if (!update) {
        return std::nullopt;
    }
    degree_ = std::max(degree_, update->degeneracy.degree);
    if (odom_at_node_) {
        const Pose2 since = between(*odom_at_node_, frame.odom_from_robot);
        if (std::hypot(since.x_m, since.y_m) < settings_.insert_distance_m &&
            std::abs(since.theta_rad) < settings_.insert_turn_rad) {
            return std::nullopt;
        }
    }
    Node node{.stamp_ns = stamp_ns,
              .scan = scan,
              .odom_from_robot = frame.odom_from_robot,
              .duration_s = duration_s_,
              .degree = degree_,
              .points = PackedScan(scan_points(frame, settings_.points))};
    odom_at_node_ = frame.odom_from_robot;
    degree_ = 0.0;
    duration_s_ = 0.0;
    return node;
}

}  // namespace ddtool::graph
