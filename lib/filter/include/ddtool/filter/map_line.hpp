#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"

namespace ddtool {

/// The piece of a wall around an occupied cell: the line through the mapped end points near it.
struct MapLine {
    float x = 0.0F, y = 0.0F;                ///< a point on the line, in cells from the occupied cell's mean point
    float normal_x = 0.0F, normal_y = 0.0F;  ///< unit vector in the world frame; (0, 0) where there is no line

    [[nodiscard]] bool exists() const { return normal_x != 0.0F || normal_y != 0.0F; }
};

/// Fits lines to the end points in a map. Unlike the surface that one scan shows, such a line comes from all scans that
/// saw the place, so that the noise of the scan that is matched has no part in it.
/// An object has no state but its settings, and serves any number of threads and grids of that cell size.
class MapLineFit {
public:
    explicit MapLineFit(double cell_size_m);

    /// The line through the mean points of the occupied cells within reach of that of `occupied`, each of which counts
    /// by its log odds, which stand in for the number of its end points. There is no line if these are fewer than
    /// three, or if they are spread across by more than ScanPoints::line_flatness of their spread along: they are then
    /// a corner, a leg or noise.
    [[nodiscard]] MapLine through(const OccupancyGrid& grid, Cell occupied) const;

private:
    int radius_cells_ = 0;
    int radius2_ = 0;  ///< in units of NearestPoint, squared
};

/// The same lines, of which those that were asked for lately are kept. A place is seen by several beams, and in several
/// matches before a scan enters the map again, and a fit takes as long as everything else that is done for a beam.
/// Asking changes an object, so that each thread needs its own, which serves any number of grids of that cell size.
class KeptMapLines {
public:
    explicit KeptMapLines(double cell_size_m) : fit_(cell_size_m), kept_(std::size_t{1} << size_bits) {}

    /// As MapLineFit::through().
    MapLine through(const OccupancyGrid& grid, Cell occupied);
    /// Has the processor fetch what through() reads first, without waiting for it.
    void prefetch(const OccupancyGrid& grid, Cell occupied) const {
        __builtin_prefetch(&kept_[place_of(grid, occupied)]);
    }

private:
    /// Thirty particles that each see a thousand cells have room.
    static constexpr int size_bits = 15;
    struct Kept {
        std::uint64_t version = 0;  ///< of the grid; no grid with a line has version 0
        Cell occupied;
        MapLine line;
    };

    static std::size_t place_of(const OccupancyGrid& grid, Cell occupied);

    MapLineFit fit_;
    std::vector<Kept> kept_;  ///< the latest line of all cells and grids that share a place
};

}  // namespace ddtool
