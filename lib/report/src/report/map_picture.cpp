#include "report/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "system/png_file.hpp"

namespace ddtool {
namespace {

constexpr double longer_side_px = 1200.0;
constexpr double most_px_per_cell = 5.0;
constexpr double margin_px = 24.0;
constexpr double footer_px = 44.0;
constexpr double least_width_px = 240.0;  ///< leaves room for the scale bar
/// shorter pieces of an anti-aliased line would add up to a line that is too thick
constexpr double path_step_px = 2.0;
/// fraction bits of the pixel coordinates for OpenCV; without them slanted lines would look bent
constexpr int fraction_bits = 4;

const cv::Scalar black(0, 0, 0);  // like all colours here, in the order blue, green, red
const cv::Scalar white(255, 255, 255);
const cv::Scalar blue(178, 114, 0);
const cv::Scalar green(115, 158, 0);
const cv::Scalar red(30, 50, 213);

/// The part of the world that a picture shows.
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

double scale_px_per_m(const Extent& extent, double cell_size_m) {
    return std::min(longer_side_px / std::max(extent.width_m(), extent.height_m()), most_px_per_cell / cell_size_m);
}

/// The largest number of the form 1, 2 or 5 times a power of ten that is at most `limit`.
double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    return limit >= 5.0 * power ? 5.0 * power : limit >= 2.0 * power ? 2.0 * power : power;
}

struct CellRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The cells along one axis that fall on a pixel. A pixel that lies on the map has at least one cell.
CellRange cells_between(double low_m, double high_m, double origin_m, double cell_size_m, std::size_t count) {
    constexpr double rounding = 1e-6;
    const double first = std::floor((low_m - origin_m) / cell_size_m + rounding);
    const double last = std::ceil((high_m - origin_m) / cell_size_m - rounding);
    const auto limited = [&](double cell) {
        return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count)));
    };
    return {limited(first), limited(last)};
}

/// The value that represents the cells of one pixel: occupied if any cell is occupied, otherwise free if any cell is
/// free. In this order thin walls stay visible when a large map is reduced.
std::int8_t winner(const MapRaster& map, const CellRange& columns, const CellRange& rows) {
    std::int8_t best = MapRaster::unknown;
    for (std::size_t y = rows.begin; y < rows.end; ++y) {
        for (std::size_t x = columns.begin; x < columns.end; ++x) {
            best = std::max(best, map.cells[y * map.width + x]);
        }
    }
    return best;
}

class Picture {
public:
    Picture(const Extent& extent, double px_per_m) : extent_(extent), px_per_m_(px_per_m) {
        const double width_px = std::max(least_width_px, extent.width_m() * px_per_m + 2.0 * margin_px);
        const double height_px = extent.height_m() * px_per_m + margin_px + footer_px;
        image_ = cv::Mat3b(static_cast<int>(std::ceil(height_px)), static_cast<int>(std::ceil(width_px)));
    }

    void draw(const MapRaster& map) {
        const double pixel_m = 1.0 / px_per_m_;
        std::vector<CellRange> columns;
        for (int column = 0; column < image_.cols; ++column) {
            const double left_m = extent_.x_min_m + (column - margin_px) * pixel_m;
            columns.push_back(cells_between(left_m, left_m + pixel_m, map.origin_m.x_m, map.cell_size_m, map.width));
        }
        for (int row = 0; row < image_.rows; ++row) {
            const double top_m = extent_.y_max_m - (row - margin_px) * pixel_m;
            const CellRange rows = cells_between(top_m - pixel_m, top_m, map.origin_m.y_m, map.cell_size_m, map.height);
            for (int column = 0; column < image_.cols; ++column) {
                const std::uint8_t level = map_grey(winner(map, columns[static_cast<std::size_t>(column)], rows));
                image_(row, column) = {level, level, level};
            }
        }
    }

    void draw(const Trajectory& path) {
        std::vector<cv::Point> points;
        for (const auto& [stamp_ns, pose] : path) {
            const cv::Point point = at(pose);
            if (points.empty() || cv::norm(point - points.back()) >= path_step_px * (1 << fraction_bits)) {
                points.push_back(point);
            }
        }
        cv::polylines(image_, points, false, blue, 2, cv::LINE_AA, fraction_bits);
        if (!path.empty()) {
            dot(path.back().pose, red, 6);
            // smaller, so that both dots are visible if the robot has returned to its start
            dot(path.front().pose, green, 3);
        }
    }

    void draw_scale_bar() {
        const double bar_m = round_length(0.25 * image_.cols / px_per_m_);
        const int left = static_cast<int>(margin_px);
        const int right = static_cast<int>(std::lround(margin_px + bar_m * px_per_m_));
        const int y = image_.rows - static_cast<int>(footer_px / 2.0);
        constexpr int tick = 5;
        cv::line(image_, {left, y}, {right, y}, black, 2);
        cv::line(image_, {left, y - tick}, {left, y + tick}, black, 2);
        cv::line(image_, {right, y - tick}, {right, y + tick}, black, 2);
        std::array<char, 32> label{};
        std::snprintf(label.data(), label.size(), "%g m", bar_m);
        cv::putText(image_, label.data(), {right + 2 * tick, y + tick}, cv::FONT_HERSHEY_SIMPLEX, 0.5, black, 1,
                    cv::LINE_AA);
    }

    void write(const std::filesystem::path& file) const { write_png(file, pixels_of(image_)); }

private:
    [[nodiscard]] cv::Point at(const Pose2& pose) const {
        const auto fixed = [](double px) { return static_cast<int>(std::lround(px * (1 << fraction_bits))); };
        return {fixed(margin_px + (pose.x_m - extent_.x_min_m) * px_per_m_),
                fixed(margin_px + (extent_.y_max_m - pose.y_m) * px_per_m_)};
    }
    void dot(const Pose2& pose, const cv::Scalar& colour, int radius_px) {
        const int radius = radius_px << fraction_bits;
        constexpr int rim = 1 << fraction_bits;
        cv::circle(image_, at(pose), radius + rim, white, cv::FILLED, cv::LINE_AA, fraction_bits);
        cv::circle(image_, at(pose), radius, colour, cv::FILLED, cv::LINE_AA, fraction_bits);
    }

    Extent extent_;
    double px_per_m_;
    cv::Mat3b image_;
};

}  // namespace

void write_map_picture(const std::filesystem::path& file, const MapRaster& map, const Trajectory& path) {
    const Extent extent = extent_of(map, path);
    Picture picture(extent, scale_px_per_m(extent, map.cell_size_m));
    picture.draw(map);
    picture.draw(path);
    picture.draw_scale_bar();
    picture.write(file);
}

}  // namespace ddtool
