#include "merging/next_drive.hpp"

#include <memory>
#include <utility>

#include "base/squared.hpp"
#include "maps/map_thinning.hpp"
#include "merging/seams.hpp"

namespace ddtool::merging {
namespace {

/// How far a drive's pose may be from the map's walls: the filter has matched each scan to them.
constexpr double on_the_map_sd_m = 0.05;
constexpr double on_the_map_sd_rad = 0.01;

std::vector<graph::RelativeEdge> seams_to(const maps::SavedMap& map, const std::vector<maps::MapNode>& nodes) {
    const RbpfSettings settings = comparing(map.grid.settings());
    const std::unique_ptr<MapSide> older = side_of(map.nodes, settings);
    const std::unique_ptr<MapSide> newer = side_of(nodes, settings);
    std::vector<ExpectedWindow> expected;
    for (std::size_t window = 0; window < newer->windows().size(); ++window) {
        ExpectedWindow one{.window = window, .pose = newer->anchor(window)};
        one.covariance.diagonal() << squared(on_the_map_sd_m), squared(on_the_map_sd_m), squared(on_the_map_sd_rad);
        expected.push_back(one);
    }
    return seams(*older, *newer, expected, settings);
}

}  // namespace

Added add_drive(maps::SavedMap& map, const maps::Drive& drive, std::vector<maps::MapNode> nodes, OccupancyGrid grid,
                const maps::GoingOnSettings& settings) {
    const std::size_t before = map.nodes.size();
    maps::SavedMap own(map.grid.settings());
    own.drives = {drive};
    const std::vector<graph::RelativeEdge> to_before = seams_to(map, nodes);
    for (maps::MapNode& node : nodes) {
        node.drive = 0;
    }
    own.nodes = std::move(nodes);
    maps::append(map, own);
    for (graph::RelativeEdge seam : to_before) {
        seam.to += before;
        map.edges.push_back({maps::MapEdge::Kind::loop, seam});
    }
    map.grid = std::move(grid);
    Added added{.seams = to_before.size()};
    if (settings.covering_scans > 0 && map.nodes.size() > before) {
        added.dropped = maps::thin(map, settings.covering_scans);
    }
    return added;
}

}  // namespace ddtool::merging
