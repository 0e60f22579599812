#include "maps/map_edit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "ddtool/base/error.hpp"

namespace ddtool::maps {
namespace {

Cell cell_of(const Point2& point, double cell_size_m) {
    return {static_cast<int>(std::floor(point.x_m / cell_size_m)),
            static_cast<int>(std::floor(point.y_m / cell_size_m))};
}

template <typename Value>
void keep(std::vector<Value>& values, const std::vector<bool>& kept) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (kept[i]) {
            values[next++] = values[i];
        }
    }
    values.resize(next);
}

/// The scan without some of its points. Where points are missing, nothing is known of the space between their
/// neighbours, as behind beams without return.
graph::PackedScan thinned(const graph::PackedScan& scan, const std::function<bool(const Point2&)>& wanted) {
    ScanPoints points = scan.unpacked();
    std::vector<bool> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        kept.push_back(wanted({double{points.x_m[i]}, double{points.y_m[i]}}));
    }
    if (std::ranges::find(kept, false) == kept.end()) {
        return scan;
    }
    std::int32_t added = 0;
    std::vector<std::size_t> kept_before{0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        added += kept[i] ? 0 : ScanPoints::order_gap;
        points.order[i] += added;
        kept_before.push_back(kept_before.back() + (kept[i] ? 1 : 0));
    }
    for (ScanPoints::Joined& joined : points.joined) {
        joined.begin = kept_before[joined.begin];
    }
    for (std::vector<float>* values :
         {&points.x_m, &points.y_m, &points.normal_x, &points.normal_y, &points.along_weight}) {
        keep(*values, kept);
    }
    keep(points.order, kept);
    return graph::PackedScan(points);
}

/// The cells of a grid moved by a pose. Free cells are looked up backwards, so that turning leaves no holes.
OccupancyGrid moved(const OccupancyGrid& grid, const Pose2& new_from_old) {
    OccupancyGrid result(grid.settings());
    const double cell_m = grid.cell_size_m();
    const CellBox box = grid.observed_box();
    if (box.empty()) {
        return result;
    }
    CellBox reach{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), std::numeric_limits<int>::min(),
                  std::numeric_limits<int>::min()};
    for (const auto& [x, y] :
         {std::pair{box.x_min, box.y_min}, {box.x_max, box.y_min}, {box.x_min, box.y_max}, {box.x_max, box.y_max}}) {
        const Cell corner = cell_of(new_from_old * Point2{x * cell_m, y * cell_m}, cell_m);
        reach = {std::min(reach.x_min, corner.x - 1), std::min(reach.y_min, corner.y - 1),
                 std::max(reach.x_max, corner.x + 2), std::max(reach.y_max, corner.y + 2)};
    }
    result.reserve(reach);
    const Pose2 old_from_new = inverse(new_from_old);
    for (int y = reach.y_min; y < reach.y_max; ++y) {
        for (int x = reach.x_min; x < reach.x_max; ++x) {
            const Cell from = cell_of(old_from_new * Point2{(x + 0.5) * cell_m, (y + 0.5) * cell_m}, cell_m);
            const std::int8_t log_odds = grid.log_odds(from);
            if (log_odds != Patch::unknown && log_odds <= 0) {
                result.set({x, y}, log_odds, {});
            }
        }
    }
    constexpr double unit = 1.0 / NearestPoint::units_per_cell;
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            if (grid.occupied({x, y})) {
                const NearestPoint mean = grid.nearest({x, y});
                const Point2 at =
                    new_from_old * Point2{(x + 0.5 + unit * mean.x) * cell_m, (y + 0.5 + unit * mean.y) * cell_m};
                const Cell cell = cell_of(at, cell_m);
                const auto offset = [&](double metres, int of) {
                    const double cells = metres / cell_m - of - 0.5;
                    return static_cast<std::int8_t>(
                        std::clamp(std::lround(cells * NearestPoint::units_per_cell), -16L, 15L));
                };
                result.set(cell, grid.log_odds({x, y}), {offset(at.x_m, cell.x), offset(at.y_m, cell.y)});
            }
        }
    }
    return result;
}

}  // namespace

void keep_nodes(SavedMap& map, const std::vector<bool>& kept) {
    std::vector<std::size_t> number(map.nodes.size());
    std::size_t next = 0;
    for (std::size_t node = 0; node < map.nodes.size(); ++node) {
        number[node] = next;
        next += kept[node] ? 1 : 0;
    }
    keep(map.nodes, kept);
    std::erase_if(map.edges, [&](const MapEdge& edge) { return !kept[edge.edge.from] || !kept[edge.edge.to]; });
    for (MapEdge& edge : map.edges) {
        edge.edge.from = number[edge.edge.from];
        edge.edge.to = number[edge.edge.to];
    }
}

std::size_t crop(SavedMap& map, const Area& area) {
    const double cell_m = map.grid.cell_size_m();
    const CellBox box = map.grid.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            if (map.grid.log_odds({x, y}) != Patch::unknown && !area.holds({(x + 0.5) * cell_m, (y + 0.5) * cell_m})) {
                map.grid.set({x, y}, Patch::unknown, {});
            }
        }
    }
    std::vector<bool> kept;
    for (MapNode& node : map.nodes) {
        kept.push_back(area.holds({node.pose.x_m, node.pose.y_m}));
        if (kept.back()) {
            node.scan.points =
                thinned(node.scan.points, [&](const Point2& point) { return area.holds(node.pose * point); });
        }
    }
    keep_nodes(map, kept);
    return map.nodes.size();
}

void set_origin(SavedMap& map, const Pose2& origin) {
    const Pose2 new_from_old = inverse(origin);
    for (MapNode& node : map.nodes) {
        node.pose = new_from_old * node.pose;
    }
    map.grid = map.nodes.empty() ? moved(map.grid, new_from_old) : drawn(map);
}

std::size_t remove_ghosts(SavedMap& map, int see_throughs) {
    if (map.nodes.empty()) {
        throw Error("the map has no scans, which tell what later scans saw through; expected a map.ddmap");
    }
    // In this grid one hit makes a cell occupied at once, and it stays so until it was seen through so often.
    OccupancySettings counting = map.grid.settings();
    counting.hit_step = see_throughs + 1;
    counting.free_step = 1;
    counting.min_log_odds = -1;
    counting.max_log_odds = see_throughs;
    const OccupancyGrid solid = drawn(map.nodes, counting);
    const double cell_m = map.grid.cell_size_m();
    for (MapNode& node : map.nodes) {
        node.scan.points = thinned(
            node.scan.points, [&](const Point2& point) { return solid.occupied(cell_of(node.pose * point, cell_m)); });
    }
    const OccupancyGrid before = map.grid;
    map.grid = drawn(map);
    std::size_t removed = 0;
    const CellBox box = before.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            removed += before.occupied({x, y}) && !map.grid.occupied({x, y}) ? 1 : 0;
        }
    }
    return removed;
}

}  // namespace ddtool::maps
