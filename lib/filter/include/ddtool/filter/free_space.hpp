#pragma once

#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// A run of cells in a row: x_begin..x_end-1.
struct CellSpan {
    int y = 0, x_begin = 0, x_end = 0;
};

/// Finds the cells that one scan saw through, each once however many beams pass it. Between two neighbouring beams
/// the triangle from the laser to their end points is free, shrunk towards the laser until its far side keeps
/// `margin_cells` from the line through the end points: along a wall that is a strip beside it, across a jump in
/// range the triangle all but vanishes.
/// Keeps its buffers between calls.
class FreeSpace {
public:
    explicit FreeSpace(double margin_cells) : margin_cells_(margin_cells) {}

    /// ends_cells: the end points of `points` in cells, in the world; origin_cells: the laser likewise.
    const std::vector<CellSpan>& find(const ScanPoints& points, const std::vector<Point2>& ends_cells,
                                      Point2 origin_cells);

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
