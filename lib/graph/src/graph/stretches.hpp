#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "graph/node.hpp"

namespace ddtool::graph {

/// A few metres of the path, whose scans make one local map in the frame of the node in its middle.
struct Stretch {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t anchor = 0;  ///< the node whose frame the local map has
    double way_m = 0.0;      ///< driven up to the anchor
};

/// Stretches of the path, each half over the next.
std::vector<Stretch> stretches_of(const std::vector<Pose2>& path);

/// The local map of a stretch, and its end points for matching them to another.
struct StretchMap {
    explicit StretchMap(const OccupancySettings& settings) : grid(settings) {}

    OccupancyGrid grid;  ///< in the anchor's frame
    ScanPoints points;   ///< in the anchor's frame, thinned to one in each square of 0.05 m
    MatchPoints match_points;
    std::vector<Point2> way;  ///< where the robot was when it took the scans, in the anchor's frame
};

/// Makes the local maps as they are asked for, and keeps the latest few.
class StretchMaps {
public:
    /// \param path world_from_robot at each node, as the stretches' shape is to be; all must outlive this
    StretchMaps(const std::vector<Node>& nodes, const std::vector<Pose2>& path, const RbpfSettings& settings)
        : nodes_(nodes), path_(path), settings_(settings) {}

    /// Throws MapTooLarge as ScanInserter does.
    std::shared_ptr<const StretchMap> map_of(const Stretch& stretch);

private:
    [[nodiscard]] std::shared_ptr<const StretchMap> made(const Stretch& stretch);

    struct Kept {
        std::size_t anchor = 0;
        std::shared_ptr<const StretchMap> map;
    };
    const std::vector<Node>& nodes_;
    const std::vector<Pose2>& path_;
    const RbpfSettings& settings_;
    ScanInserter inserter_;
    std::vector<Kept> kept_;  ///< the latest used last
};

}  // namespace ddtool::graph
