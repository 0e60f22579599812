#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/robot/scan_points.hpp"

namespace ddtool::graph {

/// The points of a scan in eight bytes each, a third of ScanPoints. Positions are rounded to 1/32767 of the farthest
/// coordinate (1.2 mm at 40 m), normals to 0.1 mrad, weights along the surface to 1/255.
class PackedScan {
public:
    PackedScan() = default;
    explicit PackedScan(const ScanPoints& points);

    /// The points, in the robot's frame as before.
    [[nodiscard]] ScanPoints unpacked() const;
    [[nodiscard]] std::size_t size() const { return points_.size(); }
    [[nodiscard]] std::size_t bytes() const;

    /// The same as one array per field, for storing. All arrays of points have the same length.
    struct Columns {
        Point2 origin_m;
        double step_m = 0.0;                  ///< unit of x and y
        std::vector<std::int16_t> x, y;       ///< in units of step_m, robot's frame
        std::vector<std::int16_t> normal;     ///< direction, in units of pi / 32767
        std::vector<std::uint8_t> along;      ///< weight along the surface, in units of 1 / 255
        std::vector<std::uint8_t> order_gap;  ///< rise of the order since the point before; a larger one counts as 255
        std::vector<ScanPoints::Joined> joined;
    };
    [[nodiscard]] Columns columns() const;
    /// Throws Error that says what is wrong if the columns are of different lengths, numbers are not finite or out of
    /// range, or the further lidars do not begin one after the other within the points.
    static PackedScan from(const Columns& columns);

private:
    struct Point {
        std::int16_t x = 0;  ///< in units of step_m_
        std::int16_t y = 0;
        std::int16_t normal = 0;     ///< direction, in units of pi / 32767
        std::uint8_t along = 0;      ///< weight along the surface, in units of 1 / 255
        std::uint8_t order_gap = 0;  ///< rise of the order since the point before; a larger one counts as 255
    };

    Point2 origin_m_;
    double step_m_ = 0.0;
    std::vector<Point> points_;
    std::vector<ScanPoints::Joined> joined_;
};

}  // namespace ddtool::graph
