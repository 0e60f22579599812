#include "ddtool/filter/beam_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/lanes.hpp"

namespace ddtool {
namespace {

/// No cell has this number.
constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();

/// The number of a cell. Cells beyond most_cells have no numbers. No map reaches that far, so the outermost number
/// serves for them.
int number_of(double whole_cells) { return static_cast<int>(std::clamp(whole_cells, -most_cells, most_cells)); }

/// A pose in cells. The whole part is kept separately, so that floats stay precise far from the origin.
struct CellPose {
    int x0, y0;
    float x, y;
    float c, s;  ///< cosine and sine of the heading
    CellPose(const Pose2& pose, double cell_size_m)
        : CellPose(pose.x_m / cell_size_m, pose.y_m / cell_size_m, pose.theta_rad) {}

private:
    CellPose(double x_cells, double y_cells, double theta_rad)
        : x0(number_of(std::floor(x_cells))),
          y0(number_of(std::floor(y_cells))),
          x(static_cast<float>(x_cells - std::floor(x_cells))),
          y(static_cast<float>(y_cells - std::floor(y_cells))),
          c(static_cast<float>(std::cos(theta_rad))),
          s(static_cast<float>(std::sin(theta_rad))) {}
};

/// The arrays that the two functions below work on. Both go over every stride-th block of lanes.
struct Arrays {
    std::size_t beams;
    std::size_t stride;
    const float *points_x, *points_y, *points_normal_x, *points_normal_y;
    const float *surface_x, *surface_y, *line_normal_x, *line_normal_y, *off_line;
    std::int32_t *cell_x, *cell_y, *moved;
    float *x, *y, *normal_x, *normal_y;
};

/// Sets the cells of the end points, whether these are others than before, and (x, y) to the end points as seen from
/// the corners of the cells.
DDTOOL_VECTORISED void place(const Arrays& arrays, const CellPose& pose) {
    // Conversion to whole numbers rounds towards zero, which is down above this offset. Cells are counted from the
    // robot here, and the settings allow no longer range.
    constexpr int offset = 1 << 14;
    for (std::size_t i = 0; i < arrays.beams; i += arrays.stride * lane_count) {
        Lanes px;
        Lanes py;
        IntLanes before_x;
        IntLanes before_y;
        load(px, arrays.points_x + i);
        load(py, arrays.points_y + i);
        load(before_x, arrays.cell_x + i);
        load(before_y, arrays.cell_y + i);
        const Lanes end_x = pose.c * px - pose.s * py + pose.x;
        const Lanes end_y = pose.s * px + pose.c * py + pose.y;
        const IntLanes whole_x = __builtin_convertvector(end_x + static_cast<float>(offset), IntLanes) - offset;
        const IntLanes whole_y = __builtin_convertvector(end_y + static_cast<float>(offset), IntLanes) - offset;
        const IntLanes now_x = whole_x + pose.x0;
        const IntLanes now_y = whole_y + pose.y0;
        store(arrays.cell_x + i, now_x);
        store(arrays.cell_y + i, now_y);
        store(arrays.moved + i, (now_x ^ before_x) | (now_y ^ before_y));
        store(arrays.x + i, end_x - __builtin_convertvector(whole_x, Lanes));
        store(arrays.y + i, end_y - __builtin_convertvector(whole_y, Lanes));
    }
}

/// Makes (x, y), which place() has set, the vectors from the surfaces, and sets their normals.
DDTOOL_VECTORISED void measure(const Arrays& arrays, const CellPose& pose) {
    for (std::size_t i = 0; i < arrays.beams; i += arrays.stride * lane_count) {
        Lanes x;
        Lanes y;
        Lanes surface_x;
        Lanes surface_y;
        Lanes nx;
        Lanes ny;
        Lanes line_x;
        Lanes line_y;
        Lanes off_line;
        load(x, arrays.x + i);
        load(y, arrays.y + i);
        load(surface_x, arrays.surface_x + i);
        load(surface_y, arrays.surface_y + i);
        load(nx, arrays.points_normal_x + i);
        load(ny, arrays.points_normal_y + i);
        load(line_x, arrays.line_normal_x + i);
        load(line_y, arrays.line_normal_y + i);
        load(off_line, arrays.off_line + i);
        store(arrays.x + i, x - surface_x);
        store(arrays.y + i, y - surface_y);
        store(arrays.normal_x + i, line_x + off_line * (pose.c * nx - pose.s * ny));
        store(arrays.normal_y + i, line_y + off_line * (pose.s * nx + pose.c * ny));
    }
}

bool any(const std::int32_t* lanes) {
    std::int32_t bits = 0;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        bits |= lanes[lane];
    }
    return bits != 0;
}

std::vector<float> padded(const std::vector<float>& values, double scale) {
    std::vector<float> result(round_up_to_lanes(values.size()), 0.0F);
    std::transform(values.begin(), values.end(), result.begin(),
                   [&](float value) { return static_cast<float>(static_cast<double>(value) * scale); });
    return result;
}

}  // namespace

MatchPoints::MatchPoints(const ScanPoints& points, double cell_size_m)
    : x(padded(points.x_m, 1.0 / cell_size_m)),
      y(padded(points.y_m, 1.0 / cell_size_m)),
      normal_x(padded(points.normal_x, 1.0)),
      normal_y(padded(points.normal_y, 1.0)),
      along_weight(padded(points.along_weight, 1.0)),
      counts(padded(std::vector<float>(points.size(), 1.0F), 1.0)),
      beams(points.size()) {}

BeamSurfaces::BeamSurfaces(double cell_size_m) : cell_size_m_(cell_size_m), lines_(cell_size_m) {}

void BeamSurfaces::begin(const MatchPoints& points) {
    const std::size_t size = points.x.size();
    for (std::vector<float>* values : {&residuals_.x, &residuals_.y, &residuals_.normal_x, &residuals_.normal_y,
                                       &residuals_.along_weight, &residuals_.found, &residuals_.known, &surface_x_,
                                       &surface_y_, &line_normal_x_, &line_normal_y_, &off_line_}) {
        values->resize(size);
    }
    cell_y_.resize(size);
    moved_.resize(size);
    occupied_.resize(size);
    forget();
}

void BeamSurfaces::forget() { cell_x_.assign(cell_y_.size(), nowhere); }

void BeamSurfaces::find(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, MeasuredAcross across,
                        std::size_t stride) {
    if (across_ != across) {
        across_ = across;
        forget();
    }
    const CellPose cells(pose, cell_size_m_);
    const Arrays arrays{.beams = points.x.size(),
                        .stride = stride,
                        .points_x = points.x.data(),
                        .points_y = points.y.data(),
                        .points_normal_x = points.normal_x.data(),
                        .points_normal_y = points.normal_y.data(),
                        .surface_x = surface_x_.data(),
                        .surface_y = surface_y_.data(),
                        .line_normal_x = line_normal_x_.data(),
                        .line_normal_y = line_normal_y_.data(),
                        .off_line = off_line_.data(),
                        .cell_x = cell_x_.data(),
                        .cell_y = cell_y_.data(),
                        .moved = moved_.data(),
                        .x = residuals_.x.data(),
                        .y = residuals_.y.data(),
                        .normal_x = residuals_.normal_x.data(),
                        .normal_y = residuals_.normal_y.data()};
    place(arrays, cells);
    // The maps of all particles together do not fit into the processor's near caches, and a cell that has to be fetched
    // takes longer than all that is done with it. So they are all asked for before the first of them is needed.
    changed_.clear();
    for (std::size_t block = 0; block < points.x.size(); block += stride * lane_count) {
        if (any(moved_.data() + block)) {
            for (std::size_t beam = block; beam < block + lane_count; ++beam) {
                if (moved_[beam] != 0) {
                    changed_.push_back(beam);
                    grid.prefetch({cell_x_[beam], cell_y_[beam]});
                }
            }
        }
    }
    for (const std::size_t beam : changed_) {
        look_up_point(grid, points, beam);
    }
    if (across == MeasuredAcross::map_lines) {
        for (const std::size_t beam : changed_) {
            look_up_line(grid, beam);
        }
    }
    measure(arrays, cells);
}

void BeamSurfaces::look_up_point(const OccupancyGrid& grid, const MatchPoints& points, std::size_t beam) {
    const Cell cell{cell_x_[beam], cell_y_[beam]};
    const NearestPoint nearest = grid.nearest(cell);
    const bool found = !nearest.none();
    const bool known = found || grid.log_odds(cell) != Patch::unknown;
    constexpr float unit = 1.0F / NearestPoint::units_per_cell;
    surface_x_[beam] = 0.5F + unit * (static_cast<float>(nearest.x) + 0.5F);
    surface_y_[beam] = 0.5F + unit * (static_cast<float>(nearest.y) + 0.5F);
    line_normal_x_[beam] = line_normal_y_[beam] = 0.0F;
    off_line_[beam] = 1.0F;
    residuals_.along_weight[beam] = points.along_weight[beam];
    residuals_.found[beam] = found ? points.counts[beam] : 0.0F;
    residuals_.known[beam] = known ? points.counts[beam] : 0.0F;
    occupied_[beam] = cell_of(nearest, cell);
    if (across_ == MeasuredAcross::map_lines && residuals_.found[beam] != 0.0F) {
        lines_.prefetch(grid, occupied_[beam]);
    }
}

void BeamSurfaces::look_up_line(const OccupancyGrid& grid, std::size_t beam) {
    if (residuals_.found[beam] == 0.0F) {
        return;
    }
    const MapLine line = lines_.through(grid, occupied_[beam]);
    if (line.exists()) {
        surface_x_[beam] += line.x;
        surface_y_[beam] += line.y;
        line_normal_x_[beam] = line.normal_x;
        line_normal_y_[beam] = line.normal_y;
        off_line_[beam] = 0.0F;
        residuals_.along_weight[beam] = 0.0F;
    }
}

}  // namespace ddtool
