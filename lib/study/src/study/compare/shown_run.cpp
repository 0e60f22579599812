#include "study/compare/shown_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

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

}  // namespace

std::string ShownEstimate::title() const {
    if (!errors) {
        return contestant;
    }
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), ": ATE %.3f m", errors->translation_m.rmse);
    return contestant + text.data();
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
            run.truth = results[index].score.ate_m ? store.truth(cell) : Trajectory{};
            run.estimates.push_back(shown_estimate(store.estimate(cell), run.truth, experiment.score));
            run.estimates.back().contestant = experiment.contestants[cell.contestant].name();
            run.estimates.back().colour = cell.contestant;
        }
    }
    return run;
}

std::size_t median_seed(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t world) {
    std::vector<double> log_products(experiment.seeds.size(), 0.0);
    for (std::size_t contestant = 0; contestant < experiment.contestants.size(); ++contestant) {
        const Summary* summary = main_summary(summaries, world, contestant);
        for (std::size_t seed = 0; summary != nullptr && seed < log_products.size(); ++seed) {
            // A failed run counts like an error of 1000 km. The value is finite, so that a contestant that fails with
            // every seed adds the same to each of them and does not influence the choice.
            log_products[seed] += std::log(std::clamp(summary->values[seed], 1e-9, 1e6));
        }
    }
    std::vector<std::size_t> order(log_products.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return log_products[a] < log_products[b]; });
    return order[(order.size() - 1) / 2];
}

}  // namespace ddtool::compare
