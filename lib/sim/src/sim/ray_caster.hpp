#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/ray.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// First hits of rays in a world. A uniform grid lists the surfaces that touch each cell; a ray walks from cell to cell
/// (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing") until a hit lies within the cell.
class RayCaster {
public:
    explicit RayCaster(const World& world);

    /// The hit on the nearest surface within max_range_m; nullopt if there is none. Safe to call from many threads.
    [[nodiscard]] std::optional<Hit> cast(const Ray& ray, double max_range_m) const;

private:
    struct Cell {
        long x = 0;
        long y = 0;
    };

    void fit_grid();
    void fill_grid();
    [[nodiscard]] std::vector<std::vector<int>> surfaces_by_cell() const;
    [[nodiscard]] Cell cell_of(const Point2& point) const;
    [[nodiscard]] Point2 centre_of(const Cell& cell) const;
    [[nodiscard]] std::size_t index_of(const Cell& cell) const {
        return static_cast<std::size_t>(cell.y * columns_ + cell.x);
    }
    [[nodiscard]] std::optional<Hit> hit(const Ray& ray, int surface) const;
    void nearest_in(const Cell& cell, const Ray& ray, std::optional<Hit>& nearest) const;

    std::vector<Segment> segments_;
    std::vector<Arc> arcs_;
    Point2 corner_;  ///< lowest x and y of the grid
    double cell_m_ = 1.0;
    long columns_ = 1;
    long rows_ = 1;
    std::vector<int> surfaces_;            ///< all cells' lists, one after the other
    std::vector<std::size_t> cell_begin_;  ///< where a cell's list begins in surfaces_; one more than there are cells
};

}  // namespace ddtool::sim
