#include "graph/coarse_map.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace ddtool::graph {
namespace {

constexpr double coarse_cell_m = 0.1;

}  // namespace

CoarseMap::CoarseMap(const OccupancyGrid& grid) {
    const CellBox box = grid.observed_box();
    const int scale = std::max(1, static_cast<int>(std::lround(coarse_cell_m / grid.cell_size_m())));
    cell_m_ = scale * grid.cell_size_m();
    x0_m_ = box.x_min * grid.cell_size_m();
    y0_m_ = box.y_min * grid.cell_size_m();
    width_ = (box.x_max - box.x_min) / scale + 1;
    height_ = (box.y_max - box.y_min) / scale + 1;
    cells_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), unknown);
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            const std::int8_t odds = grid.log_odds({x, y});
            if (odds == Patch::unknown) {
                continue;
            }
            std::uint8_t& cell = cells_[index((x - box.x_min) / scale, (y - box.y_min) / scale)];
            cell = std::max<std::uint8_t>(cell == unknown ? 0 : cell, odds > 0 ? on_wall : 0);
        }
    }
    blur();
}

void CoarseMap::blur() {
    constexpr std::uint8_t fading[] = {on_wall, 70, 30};
    std::vector<std::uint8_t> blurred = cells_;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            if (cells_[index(x, y)] != on_wall) {
                continue;
            }
            for (int v = std::max(0, y - 2); v <= std::min(height_ - 1, y + 2); ++v) {
                for (int u = std::max(0, x - 2); u <= std::min(width_ - 1, x + 2); ++u) {
                    std::uint8_t& cell = blurred[index(u, v)];
                    const std::uint8_t near = fading[std::max(std::abs(u - x), std::abs(v - y))];
                    cell = cell == unknown ? near : std::max(cell, near);
                }
            }
        }
    }
    cells_ = std::move(blurred);
}

std::vector<Point2> every_point(const ScanPoints& points, std::size_t stride) {
    std::vector<Point2> some;
    for (std::size_t i = 0; i < points.size(); i += stride) {
        some.push_back({double{points.x_m[i]}, double{points.y_m[i]}});
    }
    return some;
}

std::vector<Point2> points_of_each_direction(const ScanPoints& points, std::size_t count) {
    constexpr std::size_t directions = 8;
    std::array<std::vector<std::size_t>, directions> of_direction;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double turn = std::atan2(double{points.normal_y[i]}, double{points.normal_x[i]}) / std::numbers::pi + 1.0;
        of_direction[static_cast<std::size_t>(std::lround(turn * directions)) % directions].push_back(i);
    }
    std::array<std::size_t, directions> taken{};
    std::size_t left = std::min(count, points.size());
    for (std::size_t bin = 0; left > 0; bin = (bin + 1) % directions) {
        if (taken[bin] < of_direction[bin].size()) {
            ++taken[bin];
            --left;
        }
    }
    std::vector<Point2> result;
    for (std::size_t bin = 0; bin < directions; ++bin) {
        for (std::size_t i = 0; i < taken[bin]; ++i) {
            const std::size_t point = of_direction[bin][i * of_direction[bin].size() / taken[bin]];
            result.push_back({double{points.x_m[point]}, double{points.y_m[point]}});
        }
    }
    return result;
}

double mean_distance_m(const std::vector<Point2>& points) {
    double sum = 0.0;
    for (const Point2& point : points) {
        sum += std::hypot(point.x_m, point.y_m);
    }
    return points.empty() ? 1.0 : sum / static_cast<double>(points.size());
}

}  // namespace ddtool::graph
