#include "merging/map_merge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "base/squared.hpp"
#include "base/text.hpp"
#include "ddtool/base/error.hpp"
#include "merging/joint_graph.hpp"
#include "merging/overlap_search.hpp"
#include "merging/seams.hpp"

namespace ddtool::merging {
namespace {

/// What the local maps leave open of a window's place when they are matched closely: some cells, and a degree or two.
constexpr double expected_sd_m = 0.1;
constexpr double expected_sd_rad = 0.02;
/// The result needs so many seams that agree, for each that was dropped so many that were kept, and must be held so
/// well in every direction.
constexpr std::size_t least_seams = 3;
constexpr std::size_t kept_for_each_dropped = 4;
constexpr double most_sd_m = 0.05;
constexpr double most_sd_rad = 0.01;
/// Of the walls that both maps show, drawn at the solution.
constexpr double least_agreed = 0.85;

/// Whether the points of one scan are among those of the other, up to how they are stored: cropping a map and removing
/// its ghosts take points out.
bool same_points(const graph::PackedScan& a, const graph::PackedScan& b) {
    constexpr double stored_alike_m = 0.005;
    constexpr double least_share = 0.9;
    const ScanPoints some = (a.size() < b.size() ? a : b).unpacked();
    const ScanPoints all = (a.size() < b.size() ? b : a).unpacked();
    std::size_t shared = 0;
    std::size_t next = 0;  // both are in the order of the beams
    for (std::size_t i = 0; i < some.size(); ++i) {
        for (std::size_t j = next; j < all.size(); ++j) {
            if (std::hypot(all.x_m[j] - some.x_m[i], all.y_m[j] - some.y_m[i]) < stored_alike_m) {
                ++shared;
                next = j + 1;
                break;
            }
        }
    }
    return static_cast<double>(shared) >= least_share * static_cast<double>(some.size());
}

/// Scans of one drive have the same stamps, odometry and points, in whichever map they are. Simulated drives of one
/// seed begin with the same stamps and odometry in any place, and may see the same there for a while.
void expect_other_drives(const maps::SavedMap& first, const maps::SavedMap& second) {
    using Taken = std::tuple<std::int64_t, double, double, double>;
    const auto taken = [](const maps::MapNode& node) {
        const Pose2& odom = node.scan.odom_from_robot;
        return Taken{node.scan.stamp_ns, odom.x_m, odom.y_m, odom.theta_rad};
    };
    std::map<Taken, const graph::PackedScan*> of_first;
    for (const maps::MapNode& node : first.nodes) {
        of_first.emplace(taken(node), &node.scan.points);
    }
    std::size_t taken_alike = 0;
    std::size_t same = 0;
    for (const maps::MapNode& node : second.nodes) {
        if (const auto found = of_first.find(taken(node)); found != of_first.end()) {
            ++taken_alike;
            same += same_points(*found->second, node.scan.points) ? 1 : 0;
        }
    }
    constexpr std::size_t by_chance = 2;  // where drives begin alike
    if (same > by_chance && 2 * same > taken_alike) {
        throw Error("they hold the same drive: " + std::to_string(same) + " scans are in both");
    }
}

/// The poses of the second map in the first, each by the nearest window on the way that agrees.
std::vector<Pose2> poses_by(const Placement& placement, const OverlapSearch& search, const MapSide& second) {
    std::vector<Pose2> moved;
    for (std::size_t node = 0; node < second.poses().size(); ++node) {
        std::size_t nearest = 0;
        std::size_t apart = second.poses().size();
        for (std::size_t i = 0; i < placement.windows.size(); ++i) {
            const std::size_t anchor = second.windows()[search.compared()[i]].anchor;
            const std::size_t nodes_apart = anchor > node ? anchor - node : node - anchor;
            if (placement.windows[i].verdict == Verdict::agrees && nodes_apart < apart) {
                nearest = i;
                apart = nodes_apart;
            }
        }
        moved.push_back(placement.windows[nearest].pose *
                        between(second.anchor(search.compared()[nearest]), second.poses()[node]));
    }
    return moved;
}

std::vector<ExpectedWindow> expected_windows(const Placement& placement, const OverlapSearch& search) {
    std::vector<ExpectedWindow> expected;
    for (std::size_t i = 0; i < placement.windows.size(); ++i) {
        if (placement.windows[i].verdict == Verdict::agrees) {
            ExpectedWindow window{.window = search.compared()[i], .pose = placement.windows[i].pose};
            window.covariance.diagonal() << squared(expected_sd_m), squared(expected_sd_m), squared(expected_sd_rad);
            expected.push_back(window);
        }
    }
    return expected;
}

/// The agreement of all windows with the first map when everything is drawn at the solution.
WallAgreement agreement_of(const OccupancyGrid& first, const MapSide& second, const std::vector<std::size_t>& windows) {
    WallAgreement all;
    for (const std::size_t window : windows) {
        all += wall_agreement(*second.local_map(window), first, second.anchor(window));
    }
    return all;
}

void expect_sure(const Joined& joint) {
    if (joint.seams.size() < least_seams || joint.seams.size() < kept_for_each_dropped * joint.dropped) {
        throw Error("they have no overlap of which one can be sure: only " + std::to_string(joint.seams.size()) +
                    " of " + std::to_string(joint.seams.size() + joint.dropped) +
                    " matches of their parts agree on one place");
    }
    if (joint.sd(1) > most_sd_m || joint.sd(2) > most_sd_rad) {
        throw Error("what they share does not tell how they lie to each other: " +
                    (joint.sd(1) > most_sd_m ? "along one direction" : std::string("the turn is open")));
    }
}

/// Once the place is sure, single scans of the second map are matched to the first one as well.
Joined by_scans(const Joined& by_windows, const maps::SavedMap& first, const maps::SavedMap& second,
                const RbpfSettings& settings) {
    const auto middle = by_windows.poses.begin() + static_cast<std::ptrdiff_t>(first.nodes.size());
    const std::vector<Pose2> older(by_windows.poses.begin(), middle);
    const std::vector<Pose2> newer(middle, by_windows.poses.end());
    std::vector<maps::MapNode> moved = first.nodes;
    for (std::size_t node = 0; node < moved.size(); ++node) {
        moved[node].pose = older[node];
    }
    std::vector<graph::RelativeEdge> all =
        scan_seams(maps::drawn(moved, settings.grid), older, second.nodes, newer, settings);
    for (graph::RelativeEdge seam : by_windows.seams) {
        seam.to -= first.nodes.size();
        all.push_back(seam);
    }
    return joined(older, newer, std::move(all));
}

}  // namespace

Merged merged(const maps::SavedMap& first, const maps::SavedMap& second) {
    for (const maps::SavedMap* map : {&first, &second}) {
        if (map->nodes.empty()) {
            throw Error(std::string("the ") + (map == &first ? "first" : "second") +
                        " has no scans; expected map.ddmap of a run");
        }
    }
    expect_other_drives(first, second);
    const RbpfSettings settings = comparing(first.grid.settings());
    const std::unique_ptr<MapSide> older = side_of(first.nodes, settings);
    const std::unique_ptr<MapSide> newer = side_of(second.nodes, settings);
    OverlapSearch search(first.grid, *newer, settings);
    const Placement placement = search.find();
    const Joined by_windows = joined(older->poses(), poses_by(placement, search, *newer),
                                     seams(*older, *newer, expected_windows(placement, search), settings));
    expect_sure(by_windows);
    const Joined joint = by_scans(by_windows, first, second, settings);

    maps::SavedMap map(first.grid.settings());
    map.program = first.program;
    map.settings = first.settings;
    maps::append(map, first);
    maps::append(map, second);
    Merged result(std::move(map));
    for (std::size_t node = 0; node < joint.poses.size(); ++node) {
        result.map.nodes[node].pose = joint.poses[node];
        if (node < first.nodes.size()) {
            result.most_moved_m = std::max(result.most_moved_m, distance_m(first.nodes[node].pose, joint.poses[node]));
        }
    }
    for (const graph::RelativeEdge& seam : joint.seams) {
        result.map.edges.push_back({maps::MapEdge::Kind::loop, seam});
    }

    const std::span<const maps::MapNode> all = result.map.nodes;
    const std::vector<maps::MapNode> solved_first(all.begin(),
                                                  all.begin() + static_cast<std::ptrdiff_t>(first.nodes.size()));
    const std::vector<maps::MapNode> solved_second(all.begin() + static_cast<std::ptrdiff_t>(first.nodes.size()),
                                                   all.end());
    const WallAgreement agreement = agreement_of(maps::drawn(solved_first, first.grid.settings()),
                                                 *side_of(solved_second, settings), search.compared());
    result.agreed = agreement.share();
    if (result.agreed < least_agreed) {
        throw Error("they contradict each other where they would overlap: of the walls that both show only " +
                    fixed_text(100.0 * result.agreed, 0) + " % agree");
    }
    result.compared = search.compared().size();
    result.agreeing = placement.count(Verdict::agrees);
    result.seams = joint.seams.size();
    const std::size_t middle = joint.seams[joint.seams.size() / 2].to;
    result.first_from_second = joint.poses[middle] * inverse(second.nodes[middle - first.nodes.size()].pose);
    result.map.grid = maps::drawn(result.map);
    return result;
}

}  // namespace ddtool::merging
