#include "graph/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ddtool::graph {
namespace {

/// Long enough to see more than one scan does, and short enough that the odometry's error within it stays below a cell.
constexpr double half_length_m = 3.0;
constexpr double step_m = 3.0;  ///< from one anchor to the next
constexpr double spacing_m = 0.05;
constexpr std::size_t most_kept = 24;

/// Adds the points that lie in squares without a point so far.
void add_thinned(ScanPoints& all, std::set<std::pair<int, int>>& taken, const ScanPoints& points, const Pose2& pose) {
    const auto c = static_cast<float>(std::cos(pose.theta_rad));
    const auto s = static_cast<float>(std::sin(pose.theta_rad));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point2 at = pose * Point2{double{points.x_m[i]}, double{points.y_m[i]}};
        if (!taken
                 .emplace(static_cast<int>(std::floor(at.x_m / spacing_m)),
                          static_cast<int>(std::floor(at.y_m / spacing_m)))
                 .second) {
            continue;
        }
        all.x_m.push_back(static_cast<float>(at.x_m));
        all.y_m.push_back(static_cast<float>(at.y_m));
        all.normal_x.push_back(c * points.normal_x[i] - s * points.normal_y[i]);
        all.normal_y.push_back(s * points.normal_x[i] + c * points.normal_y[i]);
        all.along_weight.push_back(points.along_weight[i]);
        all.order.push_back(static_cast<std::int32_t>(2 * all.order.size()));
    }
}

}  // namespace

std::vector<Stretch> stretches_of(const std::vector<Pose2>& path) {
    std::vector<double> way_m(path.size(), 0.0);
    for (std::size_t node = 1; node < path.size(); ++node) {
        way_m[node] = way_m[node - 1] + distance_m(path[node - 1], path[node]);
    }
    std::vector<Stretch> stretches;
    for (std::size_t node = 0; node < path.size(); ++node) {
        if (!stretches.empty() && way_m[node] - stretches.back().way_m < step_m) {
            continue;
        }
        const auto first = std::lower_bound(way_m.begin(), way_m.end(), way_m[node] - half_length_m);
        const auto last = std::upper_bound(way_m.begin(), way_m.end(), way_m[node] + half_length_m);
        stretches.push_back({.first = static_cast<std::size_t>(first - way_m.begin()),
                             .last = static_cast<std::size_t>(last - way_m.begin()) - 1,
                             .anchor = node,
                             .way_m = way_m[node]});
    }
    return stretches;
}

std::shared_ptr<const StretchMap> StretchMaps::map_of(const Stretch& stretch) {
    const auto found =
        std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.anchor == stretch.anchor; });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back().map;
    }
    if (kept_.size() == most_kept) {
        kept_.erase(kept_.begin());
    }
    kept_.push_back({stretch.anchor, made(stretch)});
    return kept_.back().map;
}

std::shared_ptr<const StretchMap> StretchMaps::made(const Stretch& stretch) {
    auto map = std::make_shared<StretchMap>(settings_.grid);
    std::set<std::pair<int, int>> taken;
    for (std::size_t node = stretch.first; node <= stretch.last; ++node) {
        const ScanPoints points = nodes_[node].points.unpacked();
        const Pose2 pose = between(path_[stretch.anchor], path_[node]);
        inserter_.insert(map->grid, points, pose);
        add_thinned(map->points, taken, points, pose);
        map->way.push_back({pose.x_m, pose.y_m});
    }
    map->match_points = MatchPoints(map->points, settings_.grid.cell_size_m);
    return map;
}

}  // namespace ddtool::graph
