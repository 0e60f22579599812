#pragma once

#include <cstdint>
#include <optional>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/filter/update.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "graph/node.hpp"

namespace ddtool::graph {

/// Picks the scans that enter the filter's map out of a run, by the same rule as the filter, and packs them. It keeps
/// none of them. For one thread.
class NodeRecorder {
public:
    /// \param settings the filter's: when a scan enters the map, and which points a scan has
    explicit NodeRecorder(const RbpfSettings& settings) : settings_(settings) {}

    /// Call this with every frame, after the filter has processed it. `update` is empty where the frame caused no
    /// update. Returns the node if the frame's scan entered the map.
    std::optional<Node> add(const SensorFrame& frame, const std::optional<Update>& update);

    /// Scans enter the filter's map from the next update on, and none has before.
    void restart() { odom_at_node_.reset(); }

private:
    RbpfSettings settings_;
    std::size_t scans_ = 0;
    std::optional<Pose2> odom_at_node_;
    double degree_ = 0.0;  ///< the highest since the last node
    std::int64_t stamp_ns_ = 0;
    double duration_s_ = 0.0;  ///< since the last node
};

}  // namespace ddtool::graph
