#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool::graph {

/// A map on cells of about 0.1 m: how near a wall is, or that nothing was observed. Walls fade over two cells, so that
/// a search on a lattice does not step over them.
class CoarseMap {
public:
    static constexpr std::uint8_t unknown = 255;
    static constexpr std::uint8_t on_wall = 100;

    explicit CoarseMap(const OccupancyGrid& grid);

    [[nodiscard]] std::uint8_t value(double x_m, double y_m) const {
        const int x = static_cast<int>(std::floor((x_m - x0_m_) / cell_m_));
        const int y = static_cast<int>(std::floor((y_m - y0_m_) / cell_m_));
        return holds(x, y) ? cells_[index(x, y)] : unknown;
    }
    /// The value of the cell in this column and row.
    [[nodiscard]] std::uint8_t cell(int x, int y) const { return holds(x, y) ? cells_[index(x, y)] : unknown; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double cell_m() const { return cell_m_; }
    /// The lower left corner of cell (0, 0).
    [[nodiscard]] Point2 corner_m() const { return {x0_m_, y0_m_}; }

private:
    [[nodiscard]] bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    void blur();

    double cell_m_ = 0.0;
    double x0_m_ = 0.0;
    double y0_m_ = 0.0;
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> cells_;
};

/// The points of a scan that a search on a coarse map tries: every stride-th one, in the robot's frame.
std::vector<Point2> every_point(const ScanPoints& points, std::size_t stride);

/// At most `count` points of a scan, in the robot's frame: as many of each direction of the surface as there are, so
/// that the end of a corridor counts as much as its long sides (normal-space sampling, Rusinkiewicz and Levoy,
/// "Efficient variants of the ICP algorithm", 2001).
std::vector<Point2> points_of_each_direction(const ScanPoints& points, std::size_t count);

/// How far the points are from the robot in the mean, which says how fine the turns of a search must be; 1 m for none.
double mean_distance_m(const std::vector<Point2>& points);

}  // namespace ddtool::graph
