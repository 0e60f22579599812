#include <array>
#include <cmath>

#include "study/compare/run_pictures.hpp"

namespace ddtool::compare {
namespace {

/// |x|, |y| and distance of every pair, over the time since the first.
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

void draw_errors(const std::filesystem::path& file, const ShownRun& run) {
    plot::Figure figure({.width_px = 1200.0, .height_px = 800.0, .row_shares = {1.1, 1.0, 1.0}});
    const std::array<std::string, 3> labels{"|error in x| [m]", "|error in y| [m]", "distance [m]"};
    for (std::size_t row = 0; row < labels.size(); ++row) {
        figure.axes(row).y_label(labels[row]);
        for (const ShownEstimate& estimate : run.estimates) {
            const ErrorCurves curves = error_curves(*estimate.errors);
            figure.axes(row).line(curves.time_s, curves.errors_m[row],
                                  {row == 0 ? estimate.method : "", plot::series_colour(estimate.colour)});
        }
    }
    figure.axes(0).title(run.world + ", seed " + std::to_string(run.seed));
    figure.axes(2).x_label("time [s]");
    figure.write_png(file);
}

}  // namespace ddtool::compare
