#include "sim/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ddtool::sim {
namespace {

/// Cells have a side of 1 m, or more if the world would otherwise need more cells than this.
constexpr double most_cells = 1e6;
/// Surfaces are taken as larger by this, so that one on the border between two cells is listed in both in spite of
/// rounding.
constexpr double border_m = 1e-6;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    Point2 low{infinity, infinity};
    Point2 high{-infinity, -infinity};

    void include(const Point2& point, double margin_m) {
        low = {std::min(low.x_m, point.x_m - margin_m), std::min(low.y_m, point.y_m - margin_m)};
        high = {std::max(high.x_m, point.x_m + margin_m), std::max(high.y_m, point.y_m + margin_m)};
    }
};

Box bounds(const Segment& segment) {
    Box box;
    box.include(segment.a, border_m);
    box.include(segment.b, border_m);
    return box;
}

Box bounds(const Arc& arc) {
    Box box;
    box.include(arc.centre, arc.radius_m + border_m);
    return box;
}

/// Whether the surface may pass through the cell with this centre, given that its bounding box does. The result may be
/// true for a cell that the surface misses, which only costs time, but is never false for one that it touches.
bool may_touch(const Segment& segment, const Point2& centre, double cell_m) {
    const double dx = segment.b.x_m - segment.a.x_m;
    const double dy = segment.b.y_m - segment.a.y_m;
    const double side = dx * (centre.y_m - segment.a.y_m) - dy * (centre.x_m - segment.a.x_m);
    const double half = cell_m / 2.0 + border_m;
    return std::abs(side) <= half * (std::abs(dx) + std::abs(dy));
}

bool may_touch(const Arc& arc, const Point2& centre, double cell_m) {
    const double from_circle =
        std::abs(std::hypot(centre.x_m - arc.centre.x_m, centre.y_m - arc.centre.y_m) - arc.radius_m);
    return from_circle <= std::numbers::sqrt2 * (cell_m / 2.0 + border_m);
}

/// The progress of a ray through the grid along one coordinate.
struct Axis {
    Axis(double origin, double direction, long cell, double cell_m)
        : step(direction > 0.0 ? 1 : -1),
          per_cell(direction == 0.0 ? infinity : cell_m / std::abs(direction)),
          next(direction == 0.0
                   ? infinity
                   : ((static_cast<double>(cell) + (direction > 0.0 ? 1.0 : 0.0)) * cell_m - origin) / direction) {}
    long step;
    double per_cell;  ///< difference of the ranges at two successive borders
    double next;      ///< range at the next border
};

/// The range at which a coordinate of the ray enters [0, size]; infinity if it never does.
double entry_range(double origin, double direction, double size) {
    if (origin >= 0.0 && origin <= size) {
        return 0.0;
    }
    const double border = origin < 0.0 ? 0.0 : size;
    const double range = (border - origin) / direction;
    if (range >= 0.0) {
        return range;
    }
    return infinity;
}

}  // namespace

RayCaster::RayCaster(const World& world) : segments_(world.segments), arcs_(world.arcs) {
    fit_grid();
    fill_grid();
}

void RayCaster::fit_grid() {
    Box all;
    const auto include = [&](const Box& box) {
        all.include(box.low, 0.0);
        all.include(box.high, 0.0);
    };
    for (const Segment& segment : segments_) {
        include(bounds(segment));
    }
    for (const Arc& arc : arcs_) {
        include(bounds(arc));
    }
    if (all.low.x_m > all.high.x_m) {
        return;
    }
    corner_ = all.low;
    const double area = (all.high.x_m - all.low.x_m) * (all.high.y_m - all.low.y_m);
    cell_m_ = std::max(1.0, std::sqrt(area / most_cells));
    columns_ = static_cast<long>((all.high.x_m - all.low.x_m) / cell_m_) + 1;
    rows_ = static_cast<long>((all.high.y_m - all.low.y_m) / cell_m_) + 1;
}

std::vector<std::vector<int>> RayCaster::surfaces_by_cell() const {
    std::vector<std::vector<int>> cells(static_cast<std::size_t>(columns_ * rows_));
    int surface = 0;
    const auto add = [&](const auto& shape) {
        const Box box = bounds(shape);
        const Cell low = cell_of(box.low);
        const Cell high = cell_of(box.high);
        for (Cell cell = low; cell.y <= high.y; ++cell.y) {
            for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
                if (may_touch(shape, centre_of(cell), cell_m_)) {
                    cells[index_of(cell)].push_back(surface);
                }
            }
        }
        ++surface;
    };
    std::for_each(segments_.begin(), segments_.end(), add);
    std::for_each(arcs_.begin(), arcs_.end(), add);
    return cells;
}

void RayCaster::fill_grid() {
    for (const std::vector<int>& cell : surfaces_by_cell()) {
        cell_begin_.push_back(surfaces_.size());
        surfaces_.insert(surfaces_.end(), cell.begin(), cell.end());
    }
    cell_begin_.push_back(surfaces_.size());
}

RayCaster::Cell RayCaster::cell_of(const Point2& point) const {
    const auto x = static_cast<long>(std::floor((point.x_m - corner_.x_m) / cell_m_));
    const auto y = static_cast<long>(std::floor((point.y_m - corner_.y_m) / cell_m_));
    return {std::clamp(x, 0L, columns_ - 1), std::clamp(y, 0L, rows_ - 1)};
}

Point2 RayCaster::centre_of(const Cell& cell) const {
    return {corner_.x_m + (static_cast<double>(cell.x) + 0.5) * cell_m_,
            corner_.y_m + (static_cast<double>(cell.y) + 0.5) * cell_m_};
}

std::optional<Hit> RayCaster::hit(const Ray& ray, int surface) const {
    const auto index = static_cast<std::size_t>(surface);
    std::optional<Hit> found =
        index < segments_.size() ? intersect(ray, segments_[index]) : intersect(ray, arcs_[index - segments_.size()]);
    if (found) {
        found->surface = surface;
    }
    return found;
}

void RayCaster::nearest_in(const Cell& cell, const Ray& ray, std::optional<Hit>& nearest) const {
    const std::size_t index = index_of(cell);
    for (std::size_t i = cell_begin_[index]; i < cell_begin_[index + 1]; ++i) {
        const std::optional<Hit> candidate = hit(ray, surfaces_[i]);
        if (candidate && (!nearest || candidate->range_m < nearest->range_m)) {
            nearest = candidate;
        }
    }
}

std::optional<Hit> RayCaster::cast(const Ray& ray, double max_range_m) const {
    const Point2 in_grid{ray.origin.x_m - corner_.x_m, ray.origin.y_m - corner_.y_m};
    const double entry = std::max(entry_range(in_grid.x_m, ray.direction.x_m, static_cast<double>(columns_) * cell_m_),
                                  entry_range(in_grid.y_m, ray.direction.y_m, static_cast<double>(rows_) * cell_m_));
    if (!(entry <= max_range_m)) {
        return std::nullopt;
    }
    Cell cell = cell_of({ray.origin.x_m + entry * ray.direction.x_m, ray.origin.y_m + entry * ray.direction.y_m});
    Axis x(in_grid.x_m, ray.direction.x_m, cell.x, cell_m_);
    Axis y(in_grid.y_m, ray.direction.y_m, cell.y, cell_m_);
    std::optional<Hit> nearest;
    while (cell.x >= 0 && cell.x < columns_ && cell.y >= 0 && cell.y < rows_) {
        nearest_in(cell, ray, nearest);
        const double leaves = std::min(x.next, y.next);
        if (leaves > max_range_m || (nearest && nearest->range_m <= leaves)) {
            break;
        }
        if (x.next < y.next) {
            cell.x += x.step;
            x.next += x.per_cell;
        } else {
            cell.y += y.step;
            y.next += y.per_cell;
        }
    }
    return nearest && nearest->range_m <= max_range_m ? nearest : std::nullopt;
}

}  // namespace ddtool::sim
