#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "logs/messages/readings.hpp"

namespace ddtool::foxglove {

/// Decodes foxglove.LaserScan from protobuf. None when the bytes are no such message. It states no limits of range:
/// range_min_m and range_max_m are 0.
std::optional<ScanReading> protobuf_scan(std::span<const std::byte> data);

/// Decodes foxglove.PoseInFrame, FrameTransform or FrameTransforms, by the name of the type.
std::optional<std::vector<PoseReading>> protobuf_poses(std::string_view type, std::span<const std::byte> data);

}  // namespace ddtool::foxglove
