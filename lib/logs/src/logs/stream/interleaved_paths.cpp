#include "logs/stream/interleaved_paths.hpp"
#include "robot/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr double metres_per_rad = 1.0;  ///< how far apart headings count as distances
constexpr double noise = 0.02;
constexpr double speed_change = 2.0;  ///< robots stop to drive and start to turn within one step of their odometry
constexpr double first_speed = 2.0;   ///< of a path that has only one pose, whose speed is not known
constexpr double longest_prediction_s = 0.5;
constexpr double shortest_interval_s = 0.01;  ///< stamps that are closer together are jitter
constexpr double alive_s = 2.0;               ///< a path without poses for so long has ended
constexpr double branch = 0.3;                ///< a path that begins no farther from another has branched off
constexpr std::size_t least_changes = 20;
constexpr double least_regular = 0.8;  ///< share of the intervals
constexpr double times_larger = 5.0;
constexpr double least_change = 0.02;
constexpr double new_share = 0.1;  ///< of the latest interval in the running mean

double since_s(const StampedPose& from, const StampedPose& to) {
    return std::abs(seconds_between(from.stamp_ns, to.stamp_ns));
}

double apart(const Pose2& a, const Pose2& b) {
    const Pose2 step = between(a, b);
    return std::hypot(step.x_m, step.y_m) + metres_per_rad * std::abs(step.theta_rad);
}

}  // namespace

double InterleavedPaths::error(const State& state, const StampedPose& pose) {
    const double step_s = std::min(since_s(state.last, pose), longest_prediction_s);
    const Pose2 step{step_s * state.speed.x_m, step_s * state.speed.y_m, step_s * state.speed.theta_rad};
    return apart(state.last.pose * step, pose.pose);
}

void InterleavedPaths::extend(Path& path, const StampedPose& pose) {
    const double step_s = since_s(path.now.last, pose);
    path.interval_s = path.count == 1 ? step_s : path.interval_s;
    path.regular += std::abs(step_s - path.interval_s) <= path.interval_s / 2.0 ? 1 : 0;
    path.interval_s += new_share * (step_s - path.interval_s);
    if (path.count == 1 || error(path.now, pose) <= error(path.before, pose)) {
        path.before = path.now;
    }
    const double divisor_s = std::max(since_s(path.before.last, pose), shortest_interval_s);
    const Pose2 step = between(path.before.last.pose, pose.pose);
    path.now = {pose, {step.x_m / divisor_s, step.y_m / divisor_s, step.theta_rad / divisor_s}};
    ++path.count;
}

/// Where there are too many, the path takes the place of a short one that has ended.
std::size_t InterleavedPaths::begin(const Path& path) {
    if (paths_.size() < most_paths) {
        paths_.push_back(path);
        return paths_.size() - 1;
    }
    const auto is_of_no_use = [&](const Path& other) {
        return other.count < least_poses && since_s(other.now.last, path.now.last) > alive_s;
    };
    const auto place = std::ranges::find_if(paths_, is_of_no_use);
    if (place != paths_.end()) {
        *place = path;
        place->parent.reset();
    }
    return static_cast<std::size_t>(place - paths_.begin());
}

std::size_t InterleavedPaths::add(const StampedPose& pose, std::uint16_t connection) {
    std::optional<std::size_t> nearest;
    double least_error = INFINITY;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        const bool can_go_on = paths_[i].connection == connection && since_s(paths_[i].now.last, pose) < alive_s;
        const double its_error = can_go_on ? std::min(error(paths_[i].now, pose),
                                                      paths_[i].count > 1 ? error(paths_[i].before, pose) : INFINITY)
                                           : INFINITY;
        if (its_error < least_error) {
            nearest = i;
            least_error = its_error;
        }
    }
    std::size_t chosen = most_paths;
    const double step_s = nearest ? since_s(paths_[*nearest].now.last, pose) : 0.0;
    const double speed = nearest && paths_[*nearest].count == 1 ? first_speed : speed_change;
    if (nearest && least_error <= noise + speed * step_s) {
        chosen = *nearest;
        paths_[chosen].error_sum += least_error;
        extend(paths_[chosen], pose);
    } else {
        chosen = begin({.connection = connection,
                        .now = {.last = pose},
                        .count = 1,
                        .parent = least_error < branch ? nearest : std::nullopt});
    }
    if (last_ && *last_ != chosen && chosen < most_paths && *last_ < most_paths) {
        Path& before = paths_[*last_];
        const double distance = apart(before.now.last.pose, pose.pose);
        for (Path* path : {&before, &paths_[chosen]}) {
            ++path->changes;
            path->change_sum += distance;
        }
    }
    last_ = chosen;
    return chosen;
}

bool InterleavedPaths::are_interleaved() const {
    return std::ranges::any_of(paths_, [](const Path& path) {
        const auto steps = static_cast<double>(path.count - 1);
        return path.count >= least_poses && path.changes >= least_changes &&
               static_cast<double>(path.regular) >= least_regular * steps &&
               path.change_sum / static_cast<double>(path.changes) >
                   std::max(least_change, times_larger * path.error_sum / steps);
    });
}

std::vector<std::size_t> InterleavedPaths::lineage(std::size_t path) const {
    std::vector<std::size_t> lineage{path};
    // The number of paths bounds the search, because a path may have taken the place of one that it branched off from.
    for (auto up = paths_.at(path).parent; up && lineage.size() < paths_.size(); up = paths_[*up].parent) {
        lineage.insert(lineage.begin(), *up);
    }
    return lineage;
}

}  // namespace ddtool
