#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "logs/messages/readings.hpp"

namespace ddtool {

/// Decodes foxglove.LaserScan from protobuf. Returns nullopt if the bytes are not such a message. The message type has
/// no limits of range, so range_min_m and range_max_m are 0.
std::optional<ScanReading> foxglove_protobuf_scan(std::span<const std::byte> data);

/// Decodes foxglove.PointCloud from protobuf. Returns nullopt if the bytes are not such a message; a message whose
/// points cannot be read has a CloudReading::fault.
std::optional<CloudReading> foxglove_protobuf_cloud(std::span<const std::byte> data);

/// Decodes foxglove.PoseInFrame, FrameTransform or FrameTransforms from protobuf; `type` names which. Returns nullopt
/// if the bytes are not such a message.
std::optional<std::vector<PoseReading>> foxglove_protobuf_poses(std::string_view type, std::span<const std::byte> data);

}  // namespace ddtool
