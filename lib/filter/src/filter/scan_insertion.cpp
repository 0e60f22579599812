#include "ddtool/filter/scan_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace ddtool {
namespace {

Cell cell_at(Point2 cells) {
    return {static_cast<int>(std::floor(cells.x_m)), static_cast<int>(std::floor(cells.y_m))};
}

CellBox box_of(const std::vector<Point2>& ends_cells, Point2 origin_cells) {
    const Cell origin = cell_at(origin_cells);
    CellBox box{origin.x, origin.y, origin.x + 1, origin.y + 1};
    for (const Point2& end : ends_cells) {
        const Cell cell = cell_at(end);
        box = {std::min(box.x_min, cell.x), std::min(box.y_min, cell.y), std::max(box.x_max, cell.x + 1),
               std::max(box.y_max, cell.y + 1)};
    }
    return box;
}

/// The offset of a point from the centre of its cell, in NearestPoint's units.
std::int8_t offset_in_cell(double cells) {
    constexpr int half = NearestPoint::units_per_cell / 2;
    const double fraction = cells - std::floor(cells);
    return static_cast<std::int8_t>(
        std::min(static_cast<int>(fraction * NearestPoint::units_per_cell) - half, half - 1));
}

/// Throws MapTooLarge if the laser is more than most_cells from the origin along an axis, because cells have no numbers
/// there.
void expect_on_earth(const Point2& laser_m, double cell_size_m) {
    if (!(std::abs(laser_m.x_m) < most_cells * cell_size_m && std::abs(laser_m.y_m) < most_cells * cell_size_m)) {
        throw MapTooLarge("a scan taken at (" + std::to_string(laser_m.x_m) + " m, " + std::to_string(laser_m.y_m) +
                          " m): the poses jump; expected an odometry in metres");
    }
}

}  // namespace

void ScanInserter::insert(OccupancyGrid& grid, const ScanPoints& points, const Pose2& pose) {
    const double cell_size_m = grid.cell_size_m();
    project(points, pose, cell_size_m);
    Point2 laser_m = points.origin_m;
    std::size_t begin = 0;
    for (const ScanPoints::Joined& next : points.joined) {
        add_free(grid, points, pose * laser_m, begin, next.begin);
        laser_m = next.origin_m;
        begin = next.begin;
    }
    add_free(grid, points, pose * laser_m, begin, points.size());
    add_hits(grid);
}

void ScanInserter::add_free(OccupancyGrid& grid, const ScanPoints& points, const Point2& laser_m, std::size_t begin,
                            std::size_t end) {
    const double cell_size_m = grid.cell_size_m();
    const Point2 origin_cells{laser_m.x_m / cell_size_m, laser_m.y_m / cell_size_m};
    expect_on_earth(laser_m, cell_size_m);
    grid.reserve(box_of(ends_cells_, origin_cells));
    for (const CellSpan& span : free_space_.find(points, ends_cells_, origin_cells, begin, end)) {
        grid.add_free(span.y, span.x_begin, span.x_end);
    }
}

void ScanInserter::project(const ScanPoints& points, const Pose2& pose, double cell_size_m) {
    const double c = std::cos(pose.theta_rad) / cell_size_m;
    const double s = std::sin(pose.theta_rad) / cell_size_m;
    const double x = pose.x_m / cell_size_m;
    const double y = pose.y_m / cell_size_m;
    ends_cells_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto px = static_cast<double>(points.x_m[i]);
        const auto py = static_cast<double>(points.y_m[i]);
        ends_cells_[i] = {x + c * px - s * py, y + s * px + c * py};
    }
}

/// Neighbouring beams that end in the same cell count as one observation of it, at the mean of their end points.
void ScanInserter::add_hits(OccupancyGrid& grid) const {
    for (std::size_t i = 0; i < ends_cells_.size();) {
        const Cell cell = cell_at(ends_cells_[i]);
        Point2 sum;
        std::size_t end = i;
        for (; end < ends_cells_.size() && cell_at(ends_cells_[end]) == cell; ++end) {
            sum.x_m += ends_cells_[end].x_m;
            sum.y_m += ends_cells_[end].y_m;
        }
        const auto count = static_cast<double>(end - i);
        grid.add_hit(cell, {offset_in_cell(sum.x_m / count), offset_in_cell(sum.y_m / count)});
        i = end;
    }
}

}  // namespace ddtool
