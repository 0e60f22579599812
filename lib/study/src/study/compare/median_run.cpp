#include "study/compare/median_run.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ddtool::compare {

std::size_t median_seed(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t world) {
    std::vector<double> log_products(experiment.seeds.size(), 0.0);
    for (std::size_t method = 0; method < experiment.methods.size(); ++method) {
        const Summary* summary = main_summary(summaries, world, method);
        for (std::size_t seed = 0; summary != nullptr && seed < log_products.size(); ++seed) {
            // A failed run is as bad as a thousand kilometres: finite, so that methods that always fail decide nothing.
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
