#pragma once

#include <optional>
#include <utility>

#include "ddtool/filter/learnt_odometry.hpp"
#include "graph/node_recorder.hpp"
#include "maps/saved_map.hpp"
#include "small_run.hpp"

namespace ddtool::maps::test {

/// The map that a filter makes of a small drive. Computed once.
inline const SavedMap& small_map() {
    static const SavedMap kept = [] {
        ddtool::test::SmallRun small;
        const RbpfSettings settings = ddtool::test::SmallRun::settings();
        graph::NodeRecorder recorder(settings);
        SavedMap map(settings.grid);
        const FilterRun run = small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
            if (std::optional<graph::Node> node = recorder.add(frame, update)) {
                map.nodes.push_back({.drive = 0, .scan = std::move(*node), .pose = {}});
            }
            return true;
        });
        for (MapNode& node : map.nodes) {
            node.pose = run.trajectory.at(node.scan.scan).pose;
        }
        map.program = "test";
        map.settings = {{"filter", {{"particles", 3}}}};
        map.drives = {{.log = "small", .odometry = LearntOdometry().state()}};
        map.grid = run.map;
        return map;
    }();
    return kept;
}

/// Whether both grids hold the same, cell by cell, with the same nearest points.
inline bool same_cells(const OccupancyGrid& a, const OccupancyGrid& b) {
    const CellBox box = a.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            if (a.log_odds({x, y}) != b.log_odds({x, y}) ||
                (a.occupied({x, y}) && a.nearest({x, y}) != b.nearest({x, y}))) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace ddtool::maps::test
