#include "study/compare/shown_run.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace ddtool::compare {
namespace {

ShownEstimate shown_estimate(const Trajectory& estimate, const Trajectory& truth, const AteOptions& score) {
    ShownEstimate shown;
    shown.trajectory = estimate;
    if (!truth.empty()) {
        shown.errors = absolute_trajectory_error(estimate, truth, score);
        for (StampedPose& stamped : shown.trajectory) {
            stamped.pose = shown.errors->reference_from_estimate * stamped.pose;
        }
    }
    return shown;
}

void include(Extent& extent, const Trajectory& trajectory) {
    for (const StampedPose& stamped : trajectory) {
        extent.x.include(stamped.pose.x_m);
        extent.y.include(stamped.pose.y_m);
    }
}

void widen(plot::Range& range, double by) {
    range.low -= by;
    range.high += by;
}

}  // namespace

std::string ShownEstimate::title() const {
    if (!errors) {
        return method;
    }
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), ": ATE %.3f m", errors->translation_m.rmse);
    return method + text.data();
}

ShownRun shown_run(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results,
                   const ResultStore& store, std::size_t world, std::size_t seed) {
    ShownRun run;
    run.world = experiment.worlds[world].name();
    run.seed = experiment.seeds[seed];
    for (std::size_t index = 0; index < cells.size(); ++index) {
        const Cell& cell = cells[index];
        if (cell.world == world && cell.seed == seed && results[index].failure.empty()) {
            run.data = cell.data;
            run.truth = results[index].score.contains("ate_m") ? store.truth(cell) : Trajectory{};
            run.estimates.push_back(shown_estimate(store.estimate(cell), run.truth, experiment.score));
            run.estimates.back().method = experiment.methods[cell.method].name();
            run.estimates.back().colour = cell.method;
        }
    }
    return run;
}

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

}  // namespace ddtool::compare
