#include "study/compare/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scores/multiple_tests.hpp"

namespace ddtool::compare {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of one metric, by world, method and seed; infinite where a run has none.
class Values {
public:
    Values(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results,
           const Metric& metric)
        : methods_(experiment.methods.size()),
          values_(experiment.worlds.size() * methods_, std::vector<double>(experiment.seeds.size(), infinity)) {
        const Json::json_pointer path(metric.path);
        for (std::size_t index = 0; index < cells.size(); ++index) {
            const Json value = results[index].score.value(path, Json());
            if (value.is_number()) {
                values_[cells[index].world * methods_ + cells[index].method][cells[index].seed] = value;
            }
        }
    }

    [[nodiscard]] const std::vector<double>& of(std::size_t world, std::size_t method) const {
        return values_[world * methods_ + method];
    }
    [[nodiscard]] bool any(std::size_t world) const {
        for (std::size_t method = 0; method < methods_; ++method) {
            if (std::any_of(of(world, method).begin(), of(world, method).end(),
                            [](double v) { return v < infinity; })) {
                return true;
            }
        }
        return false;
    }

private:
    std::size_t methods_;
    std::vector<std::vector<double>> values_;
};

Summary summarise(const Values& values, std::size_t world, std::size_t method, std::size_t baseline) {
    Summary summary;
    summary.world = world;
    summary.method = method;
    summary.values = values.of(world, method);
    summary.failed = static_cast<std::size_t>(
        std::count_if(summary.values.begin(), summary.values.end(), [](double v) { return !std::isfinite(v); }));
    if (method != baseline) {
        summary.against_baseline = wilcoxon_signed_rank(values.of(world, baseline), summary.values);
    }
    return summary;
}

void correct_for_their_number(std::vector<Summary>& summaries) {
    std::vector<Summary*> tested;
    std::vector<double> p_values;
    for (Summary& summary : summaries) {
        if (summary.against_baseline) {
            tested.push_back(&summary);
            p_values.push_back(summary.against_baseline->p_value);
        }
    }
    const std::vector<double> adjusted = holm_adjusted(p_values);
    for (std::size_t index = 0; index < tested.size(); ++index) {
        tested[index]->holm_p_value = adjusted[index];
    }
}

}  // namespace

const std::vector<Metric>& all_metrics() {
    static const std::vector<Metric> metrics{{"ATE", "m", "/ate_m/rmse"},
                                             {"Error_x", "m", "/error_x_m/mean"},
                                             {"Error_y", "m", "/error_y_m/mean"},
                                             {"relations", "m", "/relations_m/mean"},
                                             {"relations rotation", "deg", "/relations_deg/mean"}};
    return metrics;
}

std::vector<Summary> summaries_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                  const std::vector<CellResult>& results) {
    std::vector<Summary> all;
    for (std::size_t metric = 0; metric < all_metrics().size(); ++metric) {
        const Values values(experiment, cells, results, all_metrics()[metric]);
        std::vector<Summary> summaries;
        for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
            for (std::size_t method = 0; values.any(world) && method < experiment.methods.size(); ++method) {
                summaries.push_back(summarise(values, world, method, experiment.baseline));
                summaries.back().metric = metric;
            }
        }
        correct_for_their_number(summaries);
        all.insert(all.end(), summaries.begin(), summaries.end());
    }
    return all;
}

const Summary* main_summary(const std::vector<Summary>& summaries, std::size_t world, std::size_t method) {
    const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
        return summary.world == world && summary.method == method;
    });
    return found == summaries.end() ? nullptr : &*found;
}

}  // namespace ddtool::compare
