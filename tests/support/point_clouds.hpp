#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "logs/messages/ros_messages.hpp"

namespace ddtool::test {

struct CloudPoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

/// How the points of a cloud are packed.
struct CloudLayout {
    std::uint8_t datatype = 7;  ///< of x, y and z: 7 is float32, 8 float64, 5 int32
    std::uint32_t before = 0;   ///< bytes in a point before x
    std::uint32_t behind = 4;   ///< bytes in a point behind z, such as an intensity
    std::uint32_t row_gap = 0;  ///< bytes behind each row
    std::uint32_t rows = 1;
    bool big_endian = false;
};

template <typename Number>
void append_number(std::vector<std::uint8_t>& data, double value, bool big_endian) {
    const auto number = static_cast<Number>(value);
    std::array<std::uint8_t, sizeof number> bytes{};
    std::memcpy(bytes.data(), &number, sizeof number);
    data.insert(data.end(), bytes.begin(), bytes.end());
    if (big_endian) {
        std::reverse(data.end() - sizeof number, data.end());
    }
}

/// A cloud as a driver of a lidar publishes it; the number of points is a multiple of the rows.
inline RosPointCloud2 cloud_message(double stamp_s, const std::string& frame_id, const std::vector<CloudPoint>& points,
                                    const CloudLayout& layout = {}) {
    const std::uint32_t size = layout.datatype == 8 ? 8 : 4;
    RosPointCloud2 message;
    message.header = {{std::llround(stamp_s * 1e9)}, frame_id};
    message.height = layout.rows;
    message.width = static_cast<std::uint32_t>(points.size()) / layout.rows;
    message.point_fields = {{"intensity", 0, 2, 1},
                            {"x", layout.before, layout.datatype, 1},
                            {"y", layout.before + size, layout.datatype, 1},
                            {"z", layout.before + 2 * size, layout.datatype, 1}};
    message.is_bigendian = layout.big_endian ? 1 : 0;
    message.point_step = layout.before + 3 * size + layout.behind;
    message.row_step = message.width * message.point_step + layout.row_gap;
    for (std::size_t i = 0; i < points.size(); ++i) {
        message.data.resize(message.data.size() + layout.before, 0xAB);
        for (const double value : {points[i].x, points[i].y, points[i].z}) {
            if (layout.datatype == 8) {
                append_number<double>(message.data, value, layout.big_endian);
            } else if (layout.datatype == 5) {
                append_number<std::int32_t>(message.data, value, layout.big_endian);
            } else {
                append_number<float>(message.data, value, layout.big_endian);
            }
        }
        const bool row_ends = (i + 1) % message.width == 0;
        message.data.resize(message.data.size() + layout.behind + (row_ends ? layout.row_gap : 0), 0xCD);
    }
    return message;
}

/// Points of a lidar of many rings at the height 0 in the middle of a round room of that radius: `rings` rings from
/// -15 to 15 degrees, `columns` to a turn, on the wall or, where they meet it before, the floor.
inline std::vector<CloudPoint> round_room(double radius_m, double floor_m, int rings, int columns) {
    constexpr double degree = std::numbers::pi / 180.0;
    std::vector<CloudPoint> points;
    for (int ring = 0; ring < rings; ++ring) {
        const double slope = std::tan((-15.0 + 30.0 * ring / (rings - 1)) * degree);
        const double range_m = slope * radius_m < floor_m ? floor_m / slope : radius_m;
        for (int column = 0; column < columns; ++column) {
            const double angle = 2.0 * std::numbers::pi * column / columns;
            points.push_back({range_m * std::cos(angle), range_m * std::sin(angle), range_m * slope});
        }
    }
    return points;
}

}  // namespace ddtool::test
