#include "results/map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>
#include <string>

#include "base/png_file.hpp"
#include "plot/canvas.hpp"

namespace ddtool {
namespace {

using plot::Box;
using plot::Canvas;
using plot::Colour;
using plot::Pixel;

constexpr double longer_side_px = 800.0;
constexpr double most_px_per_m = 100.0;
constexpr double margin_px = 24.0;
constexpr double footer_px = 44.0;
constexpr double least_width_px = 240.0;  ///< has room for the scale bar
constexpr std::size_t most_cells = 2000;  ///< along a side; more are merged

constexpr std::uint8_t unknown_grey = 215;
constexpr Colour page_colour{unknown_grey, unknown_grey, unknown_grey};
constexpr Colour path_colour{0, 114, 178};
constexpr Colour start_colour{0, 158, 115};
constexpr Colour end_colour{213, 50, 30};

/// How a cell looks, and which of several cells merged into one wins: walls are thin, free space is wide.
std::uint8_t grey(std::int8_t cell) {
    if (cell == MapRaster::unknown) {
        return unknown_grey;
    }
    return cell == MapRaster::occupied ? 0 : 255;
}
int rank(std::int8_t cell) { return cell == MapRaster::occupied ? 2 : cell == MapRaster::free ? 1 : 0; }

/// The map with blocks of `merged` x `merged` cells as one pixel, north up.
cv::Mat1b pixels_of(const MapRaster& map, std::size_t merged) {
    const auto count = [&](std::size_t cells) { return (cells + merged - 1) / merged; };
    cv::Mat1b pixels(static_cast<int>(count(map.height)), static_cast<int>(count(map.width)));
    for (int row = 0; row < pixels.rows; ++row) {
        for (int column = 0; column < pixels.cols; ++column) {
            const std::size_t y_begin = static_cast<std::size_t>(pixels.rows - 1 - row) * merged;
            const std::size_t x_begin = static_cast<std::size_t>(column) * merged;
            std::int8_t winner = MapRaster::unknown;
            for (std::size_t y = y_begin; y < std::min(map.height, y_begin + merged); ++y) {
                for (std::size_t x = x_begin; x < std::min(map.width, x_begin + merged); ++x) {
                    const std::int8_t cell = map.cells[y * map.width + x];
                    winner = rank(cell) > rank(winner) ? cell : winner;
                }
            }
            pixels(row, column) = grey(winner);
        }
    }
    return pixels;
}

/// The part of the world a picture shows.
struct Extent {
    double x_min_m, y_min_m, x_max_m, y_max_m;

    [[nodiscard]] double width_m() const { return x_max_m - x_min_m; }
    [[nodiscard]] double height_m() const { return y_max_m - y_min_m; }
};

Extent extent_of(const MapRaster& map, const Trajectory& path) {
    Extent extent{map.origin_m.x_m, map.origin_m.y_m, map.origin_m.x_m + map.width_m(),
                  map.origin_m.y_m + map.height_m()};
    for (const auto& [stamp_ns, pose] : path) {
        extent = {std::min(extent.x_min_m, pose.x_m), std::min(extent.y_min_m, pose.y_m),
                  std::max(extent.x_max_m, pose.x_m), std::max(extent.y_max_m, pose.y_m)};
    }
    return extent;
}

/// The longest of 1, 2, 5 times a power of ten that is at most `limit`.
double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    return limit >= 5.0 * power ? 5.0 * power : limit >= 2.0 * power ? 2.0 * power : power;
}

class Picture {
public:
    explicit Picture(const Extent& extent)
        : extent_(extent),
          px_per_m_(std::min(most_px_per_m, longer_side_px / std::max(extent.width_m(), extent.height_m()))),
          width_px_(std::max(least_width_px, std::ceil(extent.width_m() * px_per_m_) + 2.0 * margin_px)),
          height_px_(std::ceil(extent.height_m() * px_per_m_) + margin_px + footer_px),
          canvas_(width_px_, height_px_) {
        canvas_.fill({0.0, 0.0, width_px_, height_px_}, page_colour);
    }

    void draw(const MapRaster& map) {
        const std::size_t merged = (std::max(map.width, map.height) + most_cells - 1) / most_cells;
        const cv::Mat1b pixels = pixels_of(map, merged);
        const double pixel_m = map.cell_size_m * static_cast<double>(merged);
        const double height_m = pixels.rows * pixel_m;
        const Pixel top_left = at(map.origin_m.x_m, map.origin_m.y_m + height_m);
        canvas_.picture(pixels,
                        {top_left.x_px, top_left.y_px, pixels.cols * pixel_m * px_per_m_, height_m * px_per_m_});
    }

    void draw(const Trajectory& path) {
        if (path.empty()) {
            return;
        }
        std::vector<Pixel> points;
        for (const auto& [stamp_ns, pose] : path) {
            points.push_back(at(pose.x_m, pose.y_m));
        }
        canvas_.path(points, path_colour, 2.0);
        dot(points.back(), end_colour);
        dot(points.front(), start_colour);
    }

    void draw_footer() {
        const double bar_m = round_length(0.25 * width_px_ / px_per_m_);
        const double left_px = margin_px;
        const double right_px = left_px + bar_m * px_per_m_;
        const double y_px = height_px_ - footer_px / 2.0;
        canvas_.line({left_px, y_px}, {right_px, y_px}, plot::black, 2.0);
        for (const double x_px : {left_px, right_px}) {
            canvas_.line({x_px, y_px - 5.0}, {x_px, y_px + 5.0}, plot::black, 2.0);
        }
        char label[32];
        std::snprintf(label, sizeof label, "%g m", bar_m);
        canvas_.text({right_px + 10.0, y_px}, label, 11.0, plot::Anchor::left);
    }

    void write(const std::filesystem::path& file) const {
        const cv::Mat3b page = canvas_.page();
        write_png(file, {.width_px = static_cast<std::size_t>(page.cols),
                         .height_px = static_cast<std::size_t>(page.rows),
                         .channels = 3,
                         .pixels = {page.data, page.total() * page.elemSize()}});
    }

private:
    [[nodiscard]] Pixel at(double x_m, double y_m) const {
        return {margin_px + (x_m - extent_.x_min_m) * px_per_m_, margin_px + (extent_.y_max_m - y_m) * px_per_m_};
    }
    void dot(const Pixel& at, Colour colour) {
        canvas_.disc(at, 6.0, plot::white);
        canvas_.disc(at, 4.5, colour);
    }

    Extent extent_;
    double px_per_m_;
    double width_px_;
    double height_px_;
    Canvas canvas_;
};

}  // namespace

void write_map_picture(const std::filesystem::path& file, const MapRaster& map, const Trajectory& path) {
    Picture picture(extent_of(map, path));
    picture.draw(map);
    picture.draw(path);
    picture.draw_footer();
    picture.write(file);
}

}  // namespace ddtool
