#include "scores/trajectory_plot.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace ddtool {
namespace {

constexpr double page_width_px = 1000.0;

struct Columns {
    std::vector<double> time_s;  ///< since the first pair
    std::vector<double> estimate_x_m, estimate_y_m;
    std::vector<double> reference_x_m, reference_y_m;
};

Columns columns_of(const std::vector<PosePair>& pairs) {
    Columns columns;
    for (const PosePair& pair : pairs) {
        columns.time_s.push_back(static_cast<double>(pair.stamp_ns - pairs.front().stamp_ns) * 1e-9);
        columns.estimate_x_m.push_back(pair.estimate.x_m);
        columns.estimate_y_m.push_back(pair.estimate.y_m);
        columns.reference_x_m.push_back(pair.reference.x_m);
        columns.reference_y_m.push_back(pair.reference.y_m);
    }
    return columns;
}

/// The height that shows the path at equal scales over the page's width, limited to 350..800 px.
double path_panel_height_px(const Columns& columns) {
    report::Range x;
    report::Range y;
    std::for_each(columns.reference_x_m.begin(), columns.reference_x_m.end(), [&](double v) { x.include(v); });
    std::for_each(columns.reference_y_m.begin(), columns.reference_y_m.end(), [&](double v) { y.include(v); });
    return std::clamp(page_width_px * y.length() / std::max(x.length(), 1e-9), 350.0, 800.0);
}

std::string summary(const ErrorStatistics& errors) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "ATE %.3f m rmse, %.3f m median, %.3f m at most", errors.rmse,
                  errors.median, errors.max);
    return text.data();
}

}  // namespace

report::Figure ate_figure(const AteResult& result) {
    const Columns columns = columns_of(result.pairs);
    const double path_height_px = path_panel_height_px(columns);
    constexpr double error_height_px = 260.0;
    report::Figure figure({.width_px = page_width_px,
                           .height_px = path_height_px + error_height_px,
                           .row_shares = {path_height_px, error_height_px}});
    figure.axes(0)
        .title(summary(result.translation_m))
        .x_label("x [m]")
        .y_label("y [m]")
        .equal_aspect()
        .heat_line(columns.estimate_x_m, columns.estimate_y_m, result.errors_m, "error of the estimate [m]")
        .line(columns.reference_x_m, columns.reference_y_m, {"reference", report::black, 0.5});
    figure.axes(1)
        .x_label("time [s]")
        .y_label("error [m]")
        .y_range(0.0, std::max(1.05 * result.translation_m.max, 1e-9))
        .line(columns.time_s, result.errors_m);
    return figure;
}

}  // namespace ddtool
