#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "logs/messages/packed_points.hpp"

namespace ddtool {

/// The type of a number by foxglove.PackedElementField's enum of numeric types, which has another order than ROS's.
inline PointNumber foxglove_number(std::int64_t type) {
    using enum PointNumber;
    constexpr std::array numbers{none, uint8, int8, uint16, int16, uint32, int32, float32, float64};
    return type > 0 && type < static_cast<std::int64_t>(numbers.size()) ? numbers[static_cast<std::size_t>(type)]
                                                                        : none;
}

/// Sets the points of a foxglove.PointCloud, whose data are little endian and as long as its points.
inline void unpack_foxglove(CloudReading& reading, std::span<const std::byte> data, std::vector<PackedField> fields,
                            std::uint32_t point_stride) {
    unpack_into(reading, {.data = data,
                          .fields = std::move(fields),
                          .rows = 1,
                          .points_of_row = point_stride == 0 ? 0 : data.size() / point_stride,
                          .point_step = point_stride});
}

}  // namespace ddtool
