#include "ddtool/filter/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ddtool {
namespace {

Point2 towards(Point2 origin, Point2 end, double share) {
    return {origin.x_m + share * (end.x_m - origin.x_m), origin.y_m + share * (end.y_m - origin.y_m)};
}

/// The factor by which the triangle between the origin and the chord a-b is shrunk towards the origin, so that the
/// chord comes margin_cells nearer to it; 0 if the triangle is not that high.
double shrink(Point2 origin, Point2 a, Point2 b, double margin_cells) {
    const double ax = a.x_m - origin.x_m;
    const double ay = a.y_m - origin.y_m;
    const double bx = b.x_m - origin.x_m;
    const double by = b.y_m - origin.y_m;
    const double height = std::abs(ax * by - ay * bx) / std::max(std::hypot(bx - ax, by - ay), 1e-9);
    return height > margin_cells ? (height - margin_cells) / height : 0.0;
}

}  // namespace

const std::vector<CellSpan>& FreeSpace::find(const ScanPoints& points, const std::vector<Point2>& ends_cells,
                                             Point2 origin_cells, std::size_t begin, std::size_t end) {
    crossings_.clear();
    spans_.clear();
    end = std::min(end, ends_cells.size());
    double share_before = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const bool has_next = i + 1 < end && points.order[i + 1] - points.order[i] < ScanPoints::order_gap;
        const double share = has_next ? shrink(origin_cells, ends_cells[i], ends_cells[i + 1], margin_cells_) : 0.0;
        const Point2 near_point = towards(origin_cells, ends_cells[i], share);
        // Two neighbouring triangles each have an edge along this beam. Only the part of it that belongs to one
        // triangle alone is part of the outline.
        add_edge(towards(origin_cells, ends_cells[i], share_before), near_point);
        if (share > 0.0) {
            add_edge(near_point, towards(origin_cells, ends_cells[i + 1], share));
        }
        share_before = share;
    }
    collect_spans();
    return spans_;
}

/// Records where an edge of the outline crosses the centre lines of the rows of cells.
void FreeSpace::add_edge(Point2 from, Point2 to) {
    if (from.y_m > to.y_m) {
        std::swap(from, to);
    }
    const int first = static_cast<int>(std::ceil(from.y_m - 0.5));
    const int end = static_cast<int>(std::ceil(to.y_m - 0.5));
    const double slope = (to.x_m - from.x_m) / (to.y_m - from.y_m);
    for (int y = first; y < end; ++y) {
        const double x = from.x_m + (y + 0.5 - from.y_m) * slope;
        crossings_.push_back({y, static_cast<int>(std::ceil(x - 0.5))});
    }
}

/// Sorts the crossings by row (counting sort) and by x within each row. The inside of the outline lies between the
/// first and the second crossing of a row, between the third and the fourth, and so on (even-odd rule).
void FreeSpace::collect_spans() {
    if (crossings_.empty()) {
        return;
    }
    const auto [low, high] = std::minmax_element(crossings_.begin(), crossings_.end(),
                                                 [](const Crossing& a, const Crossing& b) { return a.y < b.y; });
    const int y_min = low->y;
    row_starts_.assign(static_cast<std::size_t>(high->y - y_min) + 2, 0);
    for (const Crossing& crossing : crossings_) {
        ++row_starts_[static_cast<std::size_t>(crossing.y - y_min) + 1];
    }
    for (std::size_t row = 1; row < row_starts_.size(); ++row) {
        row_starts_[row] += row_starts_[row - 1];
    }
    sorted_.resize(crossings_.size());
    for (const Crossing& crossing : crossings_) {
        sorted_[static_cast<std::size_t>(row_starts_[static_cast<std::size_t>(crossing.y - y_min)]++)] = crossing;
    }
    for (std::size_t begin = 0; begin < sorted_.size();) {
        std::size_t end = begin + 1;
        while (end < sorted_.size() && sorted_[end].y == sorted_[begin].y) {
            ++end;
        }
        std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(begin),
                  sorted_.begin() + static_cast<std::ptrdiff_t>(end),
                  [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
        for (std::size_t i = begin; i + 1 < end; i += 2) {
            if (sorted_[i].x < sorted_[i + 1].x) {
                spans_.push_back({sorted_[i].y, sorted_[i].x, sorted_[i + 1].x});
            }
        }
        begin = end;
    }
}

}  // namespace ddtool
