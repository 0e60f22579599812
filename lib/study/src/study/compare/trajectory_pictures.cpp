#include "study/compare/run_pictures.hpp"

namespace ddtool::compare {
namespace {

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

}  // namespace

void draw_trajectories(const std::filesystem::path& file, const ShownRun& run) {
    const Line truth = line_of(run.truth);
    write_side_by_side(file, extent_of(run), run.estimates.size(), [&](plot::Axes& axes, std::size_t panel) {
        const ShownEstimate& estimate = run.estimates[panel];
        const Line line = line_of(estimate.trajectory);
        axes.title(estimate.title());
        axes.line(truth.x_m, truth.y_m, {"", plot::grey, 3.0});
        axes.line(line.x_m, line.y_m, {"", plot::series_colour(estimate.colour), 1.2});
    });
}

}  // namespace ddtool::compare
