#include "run/back_end_results.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <iomanip>
#include <map>
#include <ostream>

#include "base/squared.hpp"
#include "scores/absolute_error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

Json loop_json(const graph::Loop& loop, const graph::Smoothed& smoothed) {
    const Pose2& at = smoothed.graph.poses[loop.edge.to];
    return {{"older_node", loop.edge.from},
            {"newer_node", loop.edge.to},
            {"newer_stamp_ns", smoothed.stamps_ns[loop.edge.to]},
            {"x_m", at.x_m},
            {"y_m", at.y_m},
            {"agreed", loop.agreed},
            {"open_along", loop.open_along},
            {"refusal", loop.refusal}};
}

/// The reason without its numbers, so that equal ones are counted together.
std::string kind_of(const graph::Loop& loop) {
    if (loop.refusal.empty()) {
        return loop.open_along ? "closed, but open along one direction" : "closed";
    }
    std::string reason = "refused: " + loop.refusal;
    std::erase_if(reason, [](char c) { return c >= '0' && c <= '9'; });
    return reason;
}

Trajectory sorted_by_time(Trajectory trajectory) {
    std::stable_sort(trajectory.begin(), trajectory.end(),
                     [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
    return trajectory;
}

}  // namespace

std::optional<NormalisedErrors> normalised_errors(const graph::Smoothed& smoothed, const Trajectory& ground_truth) {
    const Trajectory truth = sorted_by_time(ground_truth);
    std::optional<Pose2> ours_from_truth;
    NormalisedErrors sums;
    for (std::size_t node = 0; node < smoothed.graph.poses.size(); ++node) {
        const std::optional<Pose2> known = truth.empty() ? std::nullopt : pose_at(truth, smoothed.stamps_ns[node]);
        const Pose2& pose = smoothed.graph.poses[node];
        if (node == 0) {
            if (!known) {
                return std::nullopt;
            }
            ours_from_truth = pose * inverse(*known);
            continue;
        }
        if (!known) {
            continue;
        }
        const Pose2 expected = *ours_from_truth * *known;
        const Eigen::Vector2d error(pose.x_m - expected.x_m, pose.y_m - expected.y_m);
        const Eigen::Matrix3d& covariance = smoothed.covariances[node];
        const Eigen::Matrix2d of_position = covariance.topLeftCorner<2, 2>();
        sums.position += error.dot(of_position.ldlt().solve(error));
        sums.heading += squared(wrap_angle(pose.theta_rad - expected.theta_rad)) / covariance(2, 2);
        ++sums.nodes;
    }
    if (sums.nodes == 0) {
        return std::nullopt;
    }
    sums.position /= static_cast<double>(sums.nodes);
    sums.heading /= static_cast<double>(sums.nodes);
    return sums;
}

Json back_end_json(const BackEndResults& results) {
    const graph::Smoothed& smoothed = results.smoothed;
    const std::size_t nodes = smoothed.graph.poses.size();
    Json loops = Json::array();
    std::size_t closed = 0;
    for (const graph::Loop& loop : smoothed.loops) {
        closed += loop.refusal.empty() ? 1 : 0;
        loops.push_back(loop_json(loop, smoothed));
    }
    Json json{{"nodes", nodes},
              {"scan_bytes_per_node", nodes == 0 ? 0 : smoothed.scan_bytes / nodes},
              {"odometry_scale", smoothed.graph.calibration.scale},
              {"gyro_bias_rad_per_s", smoothed.graph.calibration.bias_rad_per_s},
              {"match_stretch", smoothed.graph.match_stretch.value},
              {"loop_error_of_filter", smoothed.loop_error_of_path},
              {"loops_closed", closed},
              {"loops_refused", smoothed.loops.size() - closed},
              {"loops", loops},
              {"wall_s", results.wall_s},
              {"cpu_s", results.cpu_s}};
    if (!results.ground_truth.empty()) {
        json["ate_rmse_of_filter_m"] =
            absolute_trajectory_error(results.by_filter, results.ground_truth).translation_m.rmse;
    }
    if (const auto errors = normalised_errors(smoothed, results.ground_truth)) {
        json["normalised_errors"] = {
            {"nodes", errors->nodes}, {"position", errors->position}, {"heading", errors->heading}};
    }
    return json;
}

Table loop_table(const std::vector<graph::Loop>& loops) {
    std::map<std::string, std::int64_t> counts;
    for (const graph::Loop& loop : loops) {
        ++counts[kind_of(loop)];
    }
    Table table({{"pairs of places"}, {"number"}});
    for (const auto& [kind, count] : counts) {
        table.add_row({kind, count});
    }
    return table;
}

void write_graph_nodes(const std::filesystem::path& file, const graph::Smoothed& smoothed) {
    write_file(file, [&](std::ostream& out) {
        out << "stamp_ns,x_m,y_m,theta_rad,cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt\n" << std::setprecision(9);
        for (std::size_t node = 0; node < smoothed.graph.poses.size(); ++node) {
            const Pose2& pose = smoothed.graph.poses[node];
            const Eigen::Matrix3d& covariance = smoothed.covariances[node];
            out << smoothed.stamps_ns[node] << ',' << pose.x_m << ',' << pose.y_m << ',' << pose.theta_rad;
            for (int row = 0; row < 3; ++row) {
                for (int column = row; column < 3; ++column) {
                    out << ',' << covariance(row, column);
                }
            }
            out << '\n';
        }
    });
}

}  // namespace ddtool
