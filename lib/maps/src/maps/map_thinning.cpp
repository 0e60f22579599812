#include "maps/map_thinning.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "filter/pose_covariance.hpp"
#include "maps/map_edit.hpp"

namespace ddtool::maps {
namespace {

/// Side of the squares in which views are compared: a few cells of a map, and about what beams are apart.
constexpr double square_m = 0.2;
constexpr double covered_share = 0.95;

/// The squares that a scan observes, each once.
class View {
public:
    explicit View(const std::vector<MapNode>& nodes) {
        double x_min = std::numeric_limits<double>::infinity();
        double y_min = x_min;
        double x_max = -x_min;
        double y_max = -x_min;
        for (const MapNode& node : nodes) {
            each_point(node, [&](const Point2& lidar, const Point2& end) {
                for (const Point2& at : {lidar, end}) {
                    x_min = std::min(x_min, at.x_m);
                    y_min = std::min(y_min, at.y_m);
                    x_max = std::max(x_max, at.x_m);
                    y_max = std::max(y_max, at.y_m);
                }
            });
        }
        if (x_min > x_max) {
            return;
        }
        x0_m_ = x_min;
        y0_m_ = y_min;
        width_ = static_cast<std::size_t>((x_max - x_min) / square_m) + 1;
        observed_.assign(width_ * (static_cast<std::size_t>((y_max - y_min) / square_m) + 1), 0);
        marked_by_.assign(observed_.size(), 0);
    }

    /// The squares in view of the node. The result holds until the next call.
    const std::vector<std::size_t>& of(const MapNode& node) {
        squares_.clear();
        ++marker_;
        each_point(node, [&](const Point2& lidar, const Point2& end) {
            const double length_m = std::hypot(end.x_m - lidar.x_m, end.y_m - lidar.y_m);
            const auto steps = static_cast<std::size_t>(std::ceil(length_m / square_m));
            for (std::size_t step = 0; step <= steps; ++step) {
                const double share = steps == 0 ? 0.0 : static_cast<double>(step) / static_cast<double>(steps);
                const std::size_t square =
                    index({lidar.x_m + share * (end.x_m - lidar.x_m), lidar.y_m + share * (end.y_m - lidar.y_m)});
                if (marked_by_[square] != marker_) {
                    marked_by_[square] = marker_;
                    squares_.push_back(square);
                }
            }
        });
        return squares_;
    }

    /// How many of the scans that were entered so far observed a square.
    [[nodiscard]] std::size_t observed(std::size_t square) const { return observed_[square]; }
    void enter(const std::vector<std::size_t>& squares) {
        for (const std::size_t square : squares) {
            ++observed_[square];
        }
    }

private:
    template <typename Visit>
    static void each_point(const MapNode& node, Visit&& visit) {
        const ScanPoints points = node.scan.points.unpacked();
        Point2 lidar = node.pose * points.origin_m;
        std::size_t next = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            while (next < points.joined.size() && points.joined[next].begin <= i) {
                lidar = node.pose * points.joined[next++].origin_m;
            }
            visit(lidar, node.pose * Point2{double{points.x_m[i]}, double{points.y_m[i]}});
        }
    }

    [[nodiscard]] std::size_t index(const Point2& at) const {
        const auto column = static_cast<std::size_t>(std::max(0.0, (at.x_m - x0_m_) / square_m));
        const auto row = static_cast<std::size_t>(std::max(0.0, (at.y_m - y0_m_) / square_m));
        return std::min(row * width_ + std::min(column, width_ - 1), observed_.size() - 1);
    }

    double x0_m_ = 0.0;
    double y0_m_ = 0.0;
    std::size_t width_ = 0;
    std::vector<std::uint32_t> observed_;
    std::vector<std::uint32_t> marked_by_;
    std::uint32_t marker_ = 0;
    std::vector<std::size_t> squares_;
};

/// The edge from the beginning of one to the end of the other, which begins where the first one ends.
std::optional<graph::RelativeEdge> in_succession(const graph::RelativeEdge& first, const graph::RelativeEdge& second) {
    const Eigen::FullPivLU<Eigen::Matrix3d> of_first(first.information);
    const Eigen::FullPivLU<Eigen::Matrix3d> of_second(second.information);
    if (!of_first.isInvertible() || !of_second.isInvertible()) {
        return std::nullopt;
    }
    // The error of the first moves the end of the second, all in the frame of that end.
    const Pose2 back = inverse(second.measured);
    Eigen::Matrix3d by_first = turned_about_z(back.theta_rad);
    const Point2 lever = Pose2{0.0, 0.0, back.theta_rad} * Point2{-second.measured.y_m, second.measured.x_m};
    by_first(0, 2) = lever.x_m;
    by_first(1, 2) = lever.y_m;
    const Eigen::Matrix3d covariance = by_first * of_first.inverse() * by_first.transpose() + of_second.inverse();
    return graph::RelativeEdge{.from = first.from,
                               .to = second.to,
                               .measured = first.measured * second.measured,
                               .information = covariance.inverse(),
                               .weight = std::min(first.weight, second.weight)};
}

/// Edges of odometry that lead over the scans which are taken out.
void bridge(SavedMap& map, const std::vector<bool>& kept) {
    std::map<std::size_t, graph::RelativeEdge> leaving;
    for (const MapEdge& edge : map.edges) {
        if (edge.kind == MapEdge::Kind::odometry) {
            leaving.emplace(edge.edge.from, edge.edge);
        }
    }
    std::vector<MapEdge> bridges;
    for (const auto& [from, edge] : leaving) {
        if (!kept[from] || kept[edge.to]) {
            continue;
        }
        std::optional<graph::RelativeEdge> whole = edge;
        while (whole && !kept[whole->to]) {
            const auto next = leaving.find(whole->to);
            whole = next == leaving.end() ? std::nullopt : in_succession(*whole, next->second);
        }
        if (whole) {
            bridges.push_back({MapEdge::Kind::odometry, *whole});
        }
    }
    map.edges.insert(map.edges.end(), bridges.begin(), bridges.end());
}

void drop_empty_drives(SavedMap& map) {
    std::vector<bool> has_scans(map.drives.size(), false);
    for (const MapNode& node : map.nodes) {
        has_scans[node.drive] = true;
    }
    std::vector<Drive> drives;
    std::vector<std::uint32_t> number(map.drives.size());
    for (std::size_t drive = 0; drive < map.drives.size(); ++drive) {
        number[drive] = static_cast<std::uint32_t>(drives.size());
        if (has_scans[drive]) {
            drives.push_back(std::move(map.drives[drive]));
        }
    }
    map.drives = std::move(drives);
    for (MapNode& node : map.nodes) {
        node.drive = number[node.drive];
    }
}

}  // namespace

std::size_t thin(SavedMap& map, std::size_t covering_scans) {
    if (map.nodes.empty()) {
        return 0;
    }
    View view(map.nodes);
    std::vector<bool> kept(map.nodes.size(), true);
    const std::uint32_t latest = map.nodes.back().drive;
    std::size_t dropped = 0;
    for (std::size_t node = map.nodes.size(); node-- > 0;) {
        const std::vector<std::size_t>& squares = view.of(map.nodes[node]);
        const auto covered =
            std::ranges::count_if(squares, [&](std::size_t square) { return view.observed(square) >= covering_scans; });
        if (map.nodes[node].drive != latest &&
            static_cast<double>(covered) >= covered_share * static_cast<double>(squares.size())) {
            kept[node] = false;
            ++dropped;
        } else {
            view.enter(squares);
        }
    }
    bridge(map, kept);
    keep_nodes(map, kept);
    drop_empty_drives(map);
    return dropped;
}

}  // namespace ddtool::maps
