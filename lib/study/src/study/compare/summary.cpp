#include "study/compare/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scores/multiple_tests.hpp"

namespace ddtool::compare {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <std::optional<ErrorStatistics> ScoreFigures::*Error, double ErrorStatistics::*Statistic>
std::optional<double> figure(const ScoreFigures& score) {
    return score.*Error ? std::optional((*(score.*Error)).*Statistic) : std::nullopt;
}

template <std::optional<ErrorStatistics> ScoreFigures::*Error>
constexpr auto mean_of = figure<Error, &ErrorStatistics::mean>;

/// The values of one metric, by world, contestant and seed. The value of a run that has none is infinite.
class Values {
public:
    Values(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results,
           const Metric& metric)
        : contestants_(experiment.contestants.size()),
          values_(experiment.worlds.size() * contestants_, std::vector<double>(experiment.seeds.size(), infinity)) {
        for (std::size_t index = 0; index < cells.size(); ++index) {
            const std::optional<double> value = metric.value(results[index].score);
            if (value && !std::isnan(*value)) {
                values_[cells[index].world * contestants_ + cells[index].contestant][cells[index].seed] = *value;
            }
        }
    }

    [[nodiscard]] const std::vector<double>& of(std::size_t world, std::size_t contestant) const {
        return values_[world * contestants_ + contestant];
    }
    [[nodiscard]] bool any(std::size_t world) const {
        for (std::size_t contestant = 0; contestant < contestants_; ++contestant) {
            if (std::any_of(of(world, contestant).begin(), of(world, contestant).end(),
                            [](double v) { return v < infinity; })) {
                return true;
            }
        }
        return false;
    }

private:
    std::size_t contestants_;
    std::vector<std::vector<double>> values_;
};

Summary summarise(const Values& values, std::size_t world, std::size_t contestant, std::size_t baseline) {
    Summary summary;
    summary.world = world;
    summary.contestant = contestant;
    summary.values = values.of(world, contestant);
    summary.failed = static_cast<std::size_t>(
        std::count_if(summary.values.begin(), summary.values.end(), [](double v) { return !std::isfinite(v); }));
    if (contestant != baseline) {
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
    static const std::vector<Metric> metrics{{"ATE", "m", figure<&ScoreFigures::ate_m, &ErrorStatistics::rmse>},
                                             {"Error_x", "m", mean_of<&ScoreFigures::error_x_m>},
                                             {"Error_y", "m", mean_of<&ScoreFigures::error_y_m>},
                                             {"relations", "m", mean_of<&ScoreFigures::relations_m>},
                                             {"relations rotation", "deg", mean_of<&ScoreFigures::relations_deg>},
                                             {"relations over 60 s", "m", mean_of<&ScoreFigures::relations_long_m>}};
    return metrics;
}

std::vector<Summary> summaries_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                  const std::vector<CellResult>& results) {
    std::vector<Summary> all;
    for (std::size_t metric = 0; metric < all_metrics().size(); ++metric) {
        const Values values(experiment, cells, results, all_metrics()[metric]);
        std::vector<Summary> summaries;
        for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
            for (std::size_t contestant = 0; values.any(world) && contestant < experiment.contestants.size();
                 ++contestant) {
                summaries.push_back(summarise(values, world, contestant, experiment.baseline));
                summaries.back().metric = metric;
            }
        }
        correct_for_their_number(summaries);
        all.insert(all.end(), summaries.begin(), summaries.end());
    }
    return all;
}

const Summary* main_summary(const std::vector<Summary>& summaries, std::size_t world, std::size_t contestant) {
    const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
        return summary.world == world && summary.contestant == contestant;
    });
    return found == summaries.end() ? nullptr : &*found;
}

}  // namespace ddtool::compare
