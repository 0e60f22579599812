#include "study/compare/result_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace ddtool::compare {
namespace {

constexpr double significance_level = 0.05;

std::string number(double value) {
    if (!std::isfinite(value)) {
        return "failed";
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return text.data();
}

std::string overview_cell(const Summary& summary) {
    const bool significant = summary.against_baseline && summary.holm_p_value < significance_level;
    return number(median(summary.values)) + " [" + number(quantile(summary.values, 0.25)) + ", " +
           number(quantile(summary.values, 0.75)) + "]" + (significant ? " *" : "");
}

std::vector<Table::Column> statistics_columns() {
    return {{"runs"}, {"failed"},     {"median"},      {"quartile 1"}, {"quartile 3"}, {"min"},
            {"max"},  {"median low"}, {"median high"}, {"difference"}, {"p", 4},       {"p (Holm)", 4}};
}

void add_statistics(std::vector<Table::Cell>& row, const Summary& summary) {
    const std::vector<double>& values = summary.values;
    const MedianInterval interval = median_interval(values);
    const double none = std::nan("");
    row.emplace_back(static_cast<std::int64_t>(values.size()));
    row.emplace_back(static_cast<std::int64_t>(summary.failed));
    for (const double value : {median(values), quantile(values, 0.25), quantile(values, 0.75), quantile(values, 0.0),
                               quantile(values, 1.0), interval.low, interval.high}) {
        row.emplace_back(value);
    }
    row.emplace_back(summary.against_baseline ? summary.against_baseline->median_difference : none);
    row.emplace_back(summary.against_baseline ? summary.against_baseline->p_value : none);
    row.emplace_back(summary.against_baseline ? summary.holm_p_value : none);
}

constexpr std::size_t printed_metrics = 3;
constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// The summary of one metric, or null if no run of the world has it.
const Summary* summary_of(const std::vector<Summary>& summaries, std::size_t world, std::size_t contestant,
                          std::size_t metric) {
    const auto found = std::ranges::find_if(summaries, [&](const Summary& each) {
        return each.world == world && each.contestant == contestant && each.metric == metric;
    });
    return found == summaries.end() ? nullptr : &*found;
}

const PrintedErrors* printed_for(const Experiment& experiment, const std::string& world, const std::string& method) {
    const auto found = std::ranges::find_if(
        experiment.paper, [&](const PrintedErrors& each) { return each.world == world && each.method == method; });
    return found == experiment.paper.end() ? nullptr : &*found;
}

double change_percent(double value, double baseline) { return 100.0 * (value / baseline - 1.0); }

/// The changes against the baseline with the same seed, of those seeds with which both have ended.
std::vector<double> changes_percent(const Summary& summary, const Summary& baseline) {
    std::vector<double> changes;
    for (std::size_t seed = 0; seed < summary.values.size(); ++seed) {
        if (std::isfinite(summary.values[seed]) && std::isfinite(baseline.values[seed])) {
            changes.push_back(change_percent(summary.values[seed], baseline.values[seed]));
        }
    }
    return changes;
}

/// The cells of a row of paper_table(). contestant: none for a method that only the paper has.
std::vector<Table::Cell> paper_row(const Experiment& experiment, const std::vector<Summary>& summaries,
                                   std::size_t world, std::optional<std::size_t> contestant,
                                   const std::string& method) {
    const std::string& world_name = experiment.worlds[world].name();
    const std::string& baseline_name = experiment.contestants[experiment.baseline].name();
    const PrintedErrors* const printed = printed_for(experiment, world_name, method);
    const PrintedErrors* const printed_baseline = printed_for(experiment, world_name, baseline_name);
    std::vector<Table::Cell> row{world_name, method};
    for (std::size_t metric = 0; metric < printed_metrics; ++metric) {
        const Summary* const summary = contestant ? summary_of(summaries, world, *contestant, metric) : nullptr;
        row.emplace_back(summary == nullptr ? not_there : median(summary->values));
        row.emplace_back(printed == nullptr ? not_there : printed->errors_m[metric]);
    }
    const Summary* const ate = contestant ? summary_of(summaries, world, *contestant, 0) : nullptr;
    const Summary* const baseline = summary_of(summaries, world, experiment.baseline, 0);
    const std::vector<double> changes = ate == nullptr || baseline == nullptr || contestant == experiment.baseline
                                            ? std::vector<double>{}
                                            : changes_percent(*ate, *baseline);
    for (const double share : {0.5, 0.25, 0.75}) {
        row.emplace_back(quantile(changes, share));
    }
    row.emplace_back(printed == nullptr || printed_baseline == nullptr || method == baseline_name
                         ? not_there
                         : change_percent(printed->errors_m[0], printed_baseline->errors_m[0]));
    return row;
}

Table with_statistics(std::vector<Table::Column> columns) {
    for (Table::Column& column : statistics_columns()) {
        columns.push_back(std::move(column));
    }
    return Table(std::move(columns));
}

}  // namespace

Table overview_table(const Experiment& experiment, const std::vector<Summary>& summaries) {
    std::vector<Table::Column> columns{{"world"}, {"error"}};
    for (const Contestant& contestant : experiment.contestants) {
        columns.push_back({contestant.name()});
    }
    Table table(columns);
    for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
        const Summary* first = main_summary(summaries, world, 0);
        const Metric metric = first == nullptr ? Metric{"-", "-", nullptr} : all_metrics()[first->metric];
        std::vector<Table::Cell> row{experiment.worlds[world].name(), metric.name + " [" + metric.unit + "]"};
        for (std::size_t contestant = 0; contestant < experiment.contestants.size(); ++contestant) {
            const Summary* summary = main_summary(summaries, world, contestant);
            row.emplace_back(summary == nullptr ? "failed" : overview_cell(*summary));
        }
        table.add_row(row);
    }
    return table;
}

Table metric_table(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t metric) {
    Table table = with_statistics({{"world"}, {"method"}});
    for (const Summary& summary : summaries) {
        if (summary.metric == metric) {
            std::vector<Table::Cell> row{experiment.worlds[summary.world].name(),
                                         experiment.contestants[summary.contestant].name()};
            add_statistics(row, summary);
            table.add_row(row);
        }
    }
    return table;
}

Table full_table(const Experiment& experiment, const std::vector<Summary>& summaries) {
    Table table = with_statistics({{"metric"}, {"unit"}, {"world"}, {"method"}});
    for (const Summary& summary : summaries) {
        const Metric& metric = all_metrics()[summary.metric];
        std::vector<Table::Cell> row{metric.name, metric.unit, experiment.worlds[summary.world].name(),
                                     experiment.contestants[summary.contestant].name()};
        add_statistics(row, summary);
        table.add_row(row);
    }
    return table;
}

Table paper_table(const Experiment& experiment, const std::vector<Summary>& summaries) {
    Table table({{"world"},
                 {"method"},
                 {"ATE [m]"},
                 {"paper ATE"},
                 {"Error_x [m]"},
                 {"paper Error_x"},
                 {"Error_y [m]"},
                 {"paper Error_y"},
                 {"change of ATE [%]", 1},
                 {"quartile 1", 1},
                 {"quartile 3", 1},
                 {"paper change [%]", 1}});
    for (std::size_t world = 0; world < experiment.worlds.size() && !experiment.paper.empty(); ++world) {
        for (std::size_t contestant = 0; contestant < experiment.contestants.size(); ++contestant) {
            table.add_row(
                paper_row(experiment, summaries, world, contestant, experiment.contestants[contestant].name()));
        }
        for (const PrintedErrors& printed : experiment.paper) {
            if (printed.world == experiment.worlds[world].name() &&
                std::ranges::find(experiment.contestants, printed.method, &Contestant::name) ==
                    experiment.contestants.end()) {
                table.add_row(paper_row(experiment, summaries, world, std::nullopt, printed.method));
            }
        }
    }
    return table;
}

Table failure_table(const Experiment& experiment, const std::vector<Cell>& cells,
                    const std::vector<CellResult>& results) {
    Table table({{"world"}, {"method"}, {"seed"}, {"why"}});
    for (std::size_t index = 0; index < cells.size(); ++index) {
        if (!results[index].failure.empty()) {
            table.add_row({experiment.worlds[cells[index].world].name(),
                           experiment.contestants[cells[index].contestant].name(),
                           static_cast<std::int64_t>(experiment.seeds[cells[index].seed]), results[index].failure});
        }
    }
    return table;
}

}  // namespace ddtool::compare
