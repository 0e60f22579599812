#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// Adjacent cells x_begin..x_end-1 of row y.
struct CellSpan {
    int y = 0, x_begin = 0, x_end = 0;
};

/// Finds the cells that the beams of one scan passed through, each cell once however many beams pass it. Between two
/// neighbouring beams, the triangle from the laser to their end points is free. It is shrunk towards the laser until
/// its far side is `margin_cells` away from the line through the end points: along a wall this leaves out a strip
/// beside the wall, and where the range jumps almost nothing of the triangle remains.
/// The object keeps its buffers between calls, so each thread needs its own.
class FreeSpace {
public:
    explicit FreeSpace(double margin_cells) : margin_cells_(margin_cells) {}

    /// ends_cells: the end points of `points` in the world frame, in units of cells; origin_cells: the laser's position
    /// in the same frame and unit. Only the points from `begin` to before `end` are used; by default all. The result is
    /// valid until the next call.
    const std::vector<CellSpan>& find(const ScanPoints& points, const std::vector<Point2>& ends_cells,
                                      Point2 origin_cells, std::size_t begin = 0,
                                      std::size_t end = std::numeric_limits<std::size_t>::max());

private:
    void add_edge(Point2 from, Point2 to);
    void collect_spans();

    struct Crossing {
        int y = 0;
        int x = 0;
    };

    double margin_cells_;
    std::vector<Crossing> crossings_;
    std::vector<Crossing> sorted_;
    std::vector<int> row_starts_;
    std::vector<CellSpan> spans_;
};

}  // namespace ddtool
