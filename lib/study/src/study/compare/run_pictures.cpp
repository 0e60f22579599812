#include "study/compare/run_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ddtool::compare {
namespace {

constexpr double page_width_px = 1500.0;
constexpr double margins_px = 90.0;  ///< what a panel needs for its title, tick texts and axis label

std::size_t columns_for(const Extent& extent, std::size_t panels) {
    const double aspect = extent.x.length() / std::max(extent.y.length(), 1e-9);
    const std::size_t most = aspect > 5.0 ? 1 : aspect > 2.0 ? 2 : 4;
    return std::min(panels, most);
}

void include(Extent& extent, const Trajectory& trajectory) {
    for (const StampedPose& stamped : trajectory) {
        extent.x.include(stamped.pose.x_m);
        extent.y.include(stamped.pose.y_m);
    }
}

void widen(report::Range& range, double by) {
    range.low -= by;
    range.high += by;
}

struct Line {
    std::vector<double> x_m, y_m;
};

Line line_of(const Trajectory& trajectory) {
    Line line;
    for (const StampedPose& stamped : trajectory) {
        line.x_m.push_back(stamped.pose.x_m);
        line.y_m.push_back(stamped.pose.y_m);
    }
    return line;
}

/// The absolute errors in x and y and the distance of every pair, over the time since the first pair.
struct ErrorCurves {
    std::vector<double> time_s;
    std::array<std::vector<double>, 3> errors_m;
};

ErrorCurves error_curves(const AteResult& errors) {
    ErrorCurves curves;
    for (const PosePair& pair : errors.pairs) {
        curves.time_s.push_back(static_cast<double>(pair.stamp_ns - errors.pairs.front().stamp_ns) * 1e-9);
        curves.errors_m[0].push_back(std::abs(pair.estimate.x_m - pair.reference.x_m));
        curves.errors_m[1].push_back(std::abs(pair.estimate.y_m - pair.reference.y_m));
    }
    curves.errors_m[2] = errors.errors_m;
    return curves;
}

}  // namespace

Extent extent_of(const ShownRun& run) {
    Extent extent;
    include(extent, run.truth);
    std::for_each(run.estimates.begin(), run.estimates.end(),
                  [&](const ShownEstimate& estimate) { include(extent, estimate.trajectory); });
    const double margin_m = 0.5 + 0.04 * std::max(extent.x.length(), extent.y.length());
    widen(extent.x, margin_m);
    widen(extent.y, margin_m);
    return extent;
}

void write_side_by_side(const std::filesystem::path& file, const Extent& extent, std::size_t panels,
                        const std::function<void(report::Axes& axes, std::size_t panel)>& draw) {
    const std::size_t columns = columns_for(extent, panels);
    const std::size_t rows = (panels + columns - 1) / columns;
    const double inner_width_px = page_width_px / static_cast<double>(columns) - margins_px;
    const double inner_height_px =
        std::clamp(inner_width_px * extent.y.length() / std::max(extent.x.length(), 1e-9), 90.0, 900.0);
    report::Figure figure({.width_px = page_width_px,
                           .height_px = static_cast<double>(rows) * (inner_height_px + margins_px),
                           .row_shares = std::vector<double>(rows, 1.0),
                           .columns = columns});
    for (std::size_t panel = 0; panel < panels; ++panel) {
        report::Axes& axes = figure.axes(panel / columns, panel % columns);
        axes.x_label("x [m]").y_label("y [m]").equal_aspect();
        axes.x_range(extent.x.low, extent.x.high).y_range(extent.y.low, extent.y.high);
        draw(axes, panel);
    }
    figure.write_png(file);
}

void draw_trajectories(const std::filesystem::path& file, const ShownRun& run) {
    const Line truth = line_of(run.truth);
    write_side_by_side(file, extent_of(run), run.estimates.size(), [&](report::Axes& axes, std::size_t panel) {
        const ShownEstimate& estimate = run.estimates[panel];
        const Line line = line_of(estimate.trajectory);
        axes.title(estimate.title());
        axes.line(truth.x_m, truth.y_m, {"", report::grey, 3.0});
        axes.line(line.x_m, line.y_m, {"", report::series_colour(estimate.colour), 1.2});
    });
}

void draw_errors(const std::filesystem::path& file, const ShownRun& run) {
    report::Figure figure({.width_px = 1200.0, .height_px = 800.0, .row_shares = {1.1, 1.0, 1.0}});
    const std::array<std::string, 3> labels{"|error in x| [m]", "|error in y| [m]", "distance [m]"};
    for (std::size_t row = 0; row < labels.size(); ++row) {
        figure.axes(row).y_label(labels[row]);
        for (const ShownEstimate& estimate : run.estimates) {
            const ErrorCurves curves = error_curves(*estimate.errors);
            figure.axes(row).line(curves.time_s, curves.errors_m[row],
                                  {row == 0 ? estimate.contestant : "", report::series_colour(estimate.colour)});
        }
    }
    figure.axes(0).title(run.world + ", seed " + std::to_string(run.seed));
    figure.axes(2).x_label("time [s]");
    figure.write_png(file);
}

}  // namespace ddtool::compare
