#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "logs/messages/readings.hpp"

namespace ddtool {

/// The types of a point's coordinates, numbered as in sensor_msgs/PointField.
enum class PointNumber : std::uint8_t {
    none = 0,
    int8 = 1,
    uint8 = 2,
    int16 = 3,
    uint16 = 4,
    int32 = 5,
    uint32 = 6,
    float32 = 7,
    float64 = 8
};

struct PackedField {
    std::string name;
    std::uint32_t offset = 0;  ///< bytes from the start of the point
    PointNumber number = PointNumber::none;
};

/// The points of a cloud as bytes, the common form of sensor_msgs/PointCloud2 and foxglove.PointCloud.
struct PackedPoints {
    std::span<const std::byte> data;
    std::vector<PackedField> fields;
    std::uint64_t rows = 1;
    std::uint64_t points_of_row = 0;
    std::uint64_t point_step = 0;  ///< bytes from point to point
    std::uint64_t row_step = 0;    ///< bytes from row to row; 0: the rows follow each other without a gap
    bool big_endian = false;
};

/// Sets the points of the reading, from the fields x, y and z, or its fault. Points with a coordinate that is no
/// number, which organised clouds have where a beam has no return, are left out.
void unpack_into(CloudReading& reading, const PackedPoints& packed);

}  // namespace ddtool
