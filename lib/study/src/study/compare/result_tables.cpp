#include "study/compare/result_tables.hpp"

#include <array>
#include <cmath>
#include <cstdio>

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
