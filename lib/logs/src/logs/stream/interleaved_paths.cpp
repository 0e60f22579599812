#include "logs/stream/interleaved_paths.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr double metres_per_rad = 1.0;  ///< how far apart headings count as distances
constexpr double noise = 0.02;
constexpr double acceleration = 3.0;
constexpr double first_speed = 2.0;  ///< of a path that has only one pose, whose speed is not known
constexpr double longest_prediction_s = 0.5;
constexpr double shortest_s = 0.01;  ///< stamps that are closer together are jitter
constexpr double alive_s = 2.0;      ///< a path without poses for so long has ended
constexpr std::size_t least_changes = 20;
constexpr std::size_t least_poses = 20;
constexpr double times_larger = 5.0;
constexpr double least_change = 0.02;

double since_s(const StampedPose& from, const StampedPose& to) {
    return std::abs(1e-9 * (static_cast<double>(to.stamp_ns) - static_cast<double>(from.stamp_ns)));
}

double apart(const Pose2& a, const Pose2& b) {
    const Pose2 step = between(a, b);
    return std::hypot(step.x_m, step.y_m) + metres_per_rad * std::abs(step.theta_rad);
}

}  // namespace

double InterleavedPaths::error(const Path& path, const StampedPose& pose) {
    const double step_s = std::min(since_s(path.last, pose), longest_prediction_s);
    const Pose2 step{step_s * path.speed.x_m, step_s * path.speed.y_m, step_s * path.speed.theta_rad};
    return apart(path.last.pose * step, pose.pose);
}

void InterleavedPaths::extend(Path& path, const StampedPose& pose) {
    const double step_s = since_s(path.last, pose);
    const double divisor_s = std::max(step_s, shortest_s);
    const Pose2 step = between(path.last.pose, pose.pose);
    path.speed = {step.x_m / divisor_s, step.y_m / divisor_s, step.theta_rad / divisor_s};
    path.last = pose;
    ++path.count;
}

std::size_t InterleavedPaths::add(const StampedPose& pose, std::uint16_t connection) {
    std::optional<std::size_t> nearest;
    double least_error = INFINITY;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        const double its_error = error(paths_[i], pose);
        if (paths_[i].connection == connection && its_error < least_error) {
            nearest = i;
            least_error = its_error;
        }
    }
    bool continues = nearest.has_value();
    if (nearest) {
        const Path& path = paths_[*nearest];
        const double step_s = since_s(path.last, pose);
        const double allowed =
            noise + 0.5 * acceleration * step_s * step_s + (path.count == 1 ? first_speed * step_s : 0.0);
        continues = least_error <= allowed;
    }
    std::size_t chosen = nearest.value_or(0);
    if (!continues && paths_.size() < most_paths) {
        chosen = paths_.size();
        paths_.push_back({.connection = connection, .last = pose, .count = 1});
    } else {
        paths_[chosen].error_sum += least_error;
        extend(paths_[chosen], pose);
    }
    if (last_ && *last_ != chosen && paths_[chosen].count > 1 && since_s(paths_[*last_].last, pose) < alive_s) {
        ++changes_;
        change_sum_ += apart(paths_[*last_].last.pose, pose.pose);
    }
    last_ = chosen;
    return chosen;
}

bool InterleavedPaths::are_interleaved() const {
    const auto is_long = [](const Path& path) { return path.count >= least_poses; };
    if (std::ranges::count_if(paths_, is_long) < 2 || changes_ < least_changes) {
        return false;
    }
    double error_sum = 0.0;
    std::size_t steps = 0;
    for (const Path& path : paths_) {
        error_sum += path.error_sum;
        steps += path.count;
    }
    const double usual_error = error_sum / static_cast<double>(steps);
    return change_sum_ / static_cast<double>(changes_) > std::max(least_change, times_larger * usual_error);
}

std::vector<std::size_t> InterleavedPaths::counts() const {
    std::vector<std::size_t> counts;
    for (const Path& path : paths_) {
        counts.push_back(path.count);
    }
    return counts;
}

}  // namespace ddtool
