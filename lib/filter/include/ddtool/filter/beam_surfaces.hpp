#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/map_line.hpp"
#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// A scan in the form that matching reads: in units of cells, padded to whole vector lanes. It is made once per scan
/// and shared by all particles.
struct MatchPoints {
    std::vector<float> x, y;                ///< end points in cells, robot frame
    std::vector<float> normal_x, normal_y;  ///< surface normals, robot frame
    std::vector<float> along_weight;        ///< weight of the squared distance along the surface
    std::vector<float> counts;              ///< 1 for a beam, 0 for padding
    std::size_t beams = 0;

    MatchPoints() = default;
    MatchPoints(const ScanPoints& points, double cell_size_m);
};

/// Where each end point lies relative to the mapped surface, in cells in the world frame.
struct Residuals {
    std::vector<float> x, y;                ///< vector from a point of the surface to the end point
    std::vector<float> normal_x, normal_y;  ///< unit normal of the surface
    std::vector<float> along_weight;        ///< weight of the squared distance along the surface
    std::vector<float> found;               ///< 1 where an occupied point is near, otherwise 0
    std::vector<float> known;  ///< 1 where one is near or the end point lies in observed ground, otherwise 0
};

/// What the distance of an end point is measured across: the surface that the scan sees, at the nearest mapped point,
/// or the line through the mapped points around that one, where there is such a line.
enum class MeasuredAcross { scan_surfaces, map_lines };

/// Finds the residuals of one scan in one grid at one pose after the other. What it measures an end point against
/// depends on the cell in which that lies alone, and a pose that is nearly settled leaves most end points in their
/// cells, so that each is looked up only when it comes to another cell.
/// An object holds only buffers: each thread needs its own, which serves any number of grids of that cell size.
class BeamSurfaces {
public:
    explicit BeamSurfaces(double cell_size_m);

    /// Has to be called before find() is called with another scan, another grid, or a grid that has changed.
    void begin(const MatchPoints& points);
    /// Sets residuals() for the robot at `pose` (world_from_robot), of every stride-th block of beams alone.
    void find(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, MeasuredAcross across,
              std::size_t stride = 1);
    [[nodiscard]] const Residuals& residuals() const { return residuals_; }

private:
    void forget();
    void look_up_point(const OccupancyGrid& grid, const MatchPoints& points, std::size_t beam);
    void look_up_line(const OccupancyGrid& grid, std::size_t beam);

    double cell_size_m_;
    KeptMapLines lines_;
    MeasuredAcross across_ = MeasuredAcross::scan_surfaces;
    Residuals residuals_;
    std::vector<std::int32_t> cell_x_, cell_y_;         ///< where each end point was when it was looked up
    std::vector<std::int32_t> moved_;                   ///< 0 where it is still in that cell
    std::vector<std::size_t> changed_;                  ///< the beams that are to be looked up
    std::vector<Cell> occupied_;                        ///< the cell of the nearest occupied point, if there is one
    std::vector<float> surface_x_, surface_y_;          ///< a point of the surface, in cells from the cell's corner
    std::vector<float> line_normal_x_, line_normal_y_;  ///< of the map's line; (0, 0) where there is none
    std::vector<float> off_line_;                       ///< 1 where the scan's own surface counts, otherwise 0
};

}  // namespace ddtool
