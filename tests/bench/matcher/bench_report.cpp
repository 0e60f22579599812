#include "bench_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "methods/settings_json.hpp"
#include "report/figure.hpp"
#include "report/table.hpp"

namespace ddtool::matcher_bench {
namespace {

constexpr double milli = 1e3;  // metres and radians are shown as mm and mrad
constexpr double centi = 1e2;
constexpr std::array<const char*, axis_count> axis_names{"along", "across", "heading"};

std::string with_error(const Mean& mean, double scale, int decimals) {
    if (std::isnan(mean.value)) {
        return "-";
    }
    return fixed_text(scale * mean.value, decimals) + " ± " + fixed_text(scale * mean.standard_error, decimals);
}

/// "360 x 12 m, 15 mm"
std::string lidar_text(const sim::LidarSettings& lidar) {
    return std::to_string(lidar.beams) + " x " + fixed_text(lidar.range_max_m, 0) + " m, " +
           fixed_text(milli * lidar.range_noise_m, 0) + " mm";
}

std::string cell_text(double cell_size_m) { return fixed_text(centi * cell_size_m, 1) + " cm"; }

Table table_of_cases(const std::vector<Table::Column>& columns) {
    std::vector<Table::Column> all{{"world"}, {"lidar"}, {"cells"}};
    all.insert(all.end(), columns.begin(), columns.end());
    return Table(all);
}

void add_case(Table& table, const CaseResult& result, std::vector<Table::Cell> cells) {
    cells.insert(cells.begin(), {result.world, lidar_text(result.lidar), cell_text(result.cell_size_m)});
    table.add_row(std::move(cells));
}

std::string bias_table(const std::vector<CaseResult>& results) {
    Table table = table_of_cases({{"matches"},
                                  {"lost"},
                                  {"along, mm"},
                                  {"across, mm"},
                                  {"heading, mrad"},
                                  {"first step along, mm"},
                                  {"displaced: along, mm"},
                                  {"drift, %"}});
    for (const CaseResult& result : results) {
        const auto& axes = result.summary.axes;
        add_case(table, result,
                 {static_cast<std::int64_t>(result.summary.matches), static_cast<std::int64_t>(result.summary.lost),
                  with_error(axes[along].bias, milli, 2), with_error(axes[across].bias, milli, 2),
                  with_error(axes[heading].bias, milli, 2), with_error(axes[along].first_step, milli, 2),
                  with_error(axes[along].bias_displaced, milli, 2), with_error(result.summary.drift, centi, 3)});
    }
    return table.markdown();
}

std::string spread_table(const std::vector<CaseResult>& results) {
    std::vector<Table::Column> columns;
    for (const char* axis : axis_names) {
        const std::string unit = axis == axis_names[heading] ? ", mrad" : ", mm";
        columns.push_back({axis + unit, 2});
        columns.push_back({"bound", 2});
        columns.push_back({"ratio", 2});
        columns.push_back({"left, %", 1});
    }
    Table table = table_of_cases(columns);
    for (const CaseResult& result : results) {
        std::vector<Table::Cell> cells;
        for (const AxisSummary& axis : result.summary.axes) {
            cells.insert(cells.end(),
                         {milli * axis.spread, milli * axis.bound, axis.spread / axis.bound, centi * axis.left});
        }
        add_case(table, result, std::move(cells));
    }
    return table.markdown();
}

std::string belief_table(const std::vector<CaseResult>& results) {
    std::vector<Table::Column> columns;
    for (const char* axis : axis_names) {
        const std::string unit = axis == axis_names[heading] ? ", mrad" : ", mm";
        columns.push_back({axis + std::string(" believed") + unit, 2});
        columns.push_back({"squared error / believed"});
    }
    Table table = table_of_cases(columns);
    for (const CaseResult& result : results) {
        std::vector<Table::Cell> cells;
        for (const AxisSummary& axis : result.summary.axes) {
            cells.insert(cells.end(), {milli * axis.believed, with_error(axis.normalised, 1.0, 2)});
        }
        add_case(table, result, std::move(cells));
    }
    return table.markdown();
}

Json number_json(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

Json mean_json(const Mean& mean) {
    return {{"mean", number_json(mean.value)}, {"standard_error", number_json(mean.standard_error)}};
}

Json axis_json(const AxisSummary& axis) {
    return {{"held", axis.held},
            {"bias", mean_json(axis.bias)},
            {"spread", number_json(axis.spread)},
            {"bound", number_json(axis.bound)},
            {"normalised_squared_error", mean_json(axis.normalised)},
            {"first_step", mean_json(axis.first_step)},
            {"displaced_bias", mean_json(axis.bias_displaced)},
            {"displaced_spread", number_json(axis.spread_displaced)},
            {"displacement_left", number_json(axis.left)},
            {"believed", number_json(axis.believed)}};
}

Json case_json(const CaseResult& result) {
    Json axes;
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
        axes[axis_names[axis]] = axis_json(result.summary.axes[axis]);
    }
    return {{"world", result.world},
            {"beams", result.lidar.beams},
            {"range_max_m", result.lidar.range_max_m},
            {"range_noise_m", result.lidar.range_noise_m},
            {"cell_size_m", result.cell_size_m},
            {"matches", result.summary.matches},
            {"lost", result.summary.lost},
            {"axes", axes},
            {"drift", mean_json(result.summary.drift)}};
}

}  // namespace

std::string tables(const std::vector<CaseResult>& results) {
    return "**Bias** (mean error ± standard error)\n\n" + bias_table(results) +
           "\n**Spread** (standard deviation of the error; Cramér-Rao bound; their ratio; share of a displacement that "
           "is "
           "left)\n\n" +
           spread_table(results) +
           "\n**Belief** (standard deviation that the match believes; normalised error squared)\n\n" +
           belief_table(results);
}

Json results_json(const Plan& plan, const std::vector<CaseResult>& results) {
    FilterSettings filter;
    filter.rbpf = plan.trials.filter;
    Json cases = Json::array();
    for (const CaseResult& result : results) {
        cases.push_back(case_json(result));
    }
    return {{"layouts", plan.layouts},
            {"length_m", plan.length_m},
            {"map", plan.known_map ? "known" : "frontier"},
            {"seed", plan.trials.seed},
            {"displacement_m", plan.trials.displacement_m},
            {"displacement_rad", plan.trials.displacement_rad},
            {"matcher", filter_settings_json(filter)["matcher"]},
            {"cases", cases}};
}

void write_picture(const std::filesystem::path& path, const std::vector<CaseResult>& results) {
    std::vector<std::string> names;
    std::vector<std::string> cells;
    const auto place_of = [](std::vector<std::string>& words, const std::string& word) {
        const auto found = std::find(words.begin(), words.end(), word);
        if (found != words.end()) {
            return static_cast<std::size_t>(found - words.begin());
        }
        words.push_back(word);
        return words.size() - 1;
    };
    const bool one_lidar = std::all_of(results.begin(), results.end(), [&](const CaseResult& result) {
        return lidar_text(result.lidar) == lidar_text(results.front().lidar);
    });
    const auto name_of = [&](const CaseResult& result) {
        return one_lidar ? result.world : result.world + ", " + lidar_text(result.lidar);
    };
    for (const CaseResult& result : results) {
        place_of(names, name_of(result));
        place_of(cells, cell_text(result.cell_size_m));
    }
    const auto bars_of = [&](const auto& value) {
        std::vector<report::BarSeries> series;
        for (const std::string& cell : cells) {
            series.push_back({cell, std::vector<double>(names.size(), missing)});
        }
        for (const CaseResult& result : results) {
            series[place_of(cells, cell_text(result.cell_size_m))].heights[place_of(names, name_of(result))] =
                value(result.summary);
        }
        return series;
    };
    report::Figure figure({.width_px = 1200.0, .height_px = 1100.0, .row_shares = {1.0, 1.0, 1.0}});
    figure.axes(0)
        .title("Scan matching from the true pose")
        .y_label("bias along, mm")
        .bars(names, bars_of([](const Summary& summary) { return milli * summary.axes[along].bias.value; }));
    figure.axes(1).y_label("drift, %").bars(names, bars_of([](const Summary& summary) {
                                                return centi * summary.drift.value;
                                            }));
    figure.axes(2).y_label("spread / bound, along").bars(names, bars_of([](const Summary& summary) {
                                                             return summary.axes[along].spread /
                                                                    summary.axes[along].bound;
                                                         }));
    figure.write_png(path);
}

}  // namespace ddtool::matcher_bench
