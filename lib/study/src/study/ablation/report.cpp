#include "study/ablation/report.hpp"

#include <algorithm>
#include <limits>

#include "scores/statistics.hpp"
#include "study/ablation/inference_time.hpp"
#include "system/log.hpp"

namespace ddtool::ablation {
namespace {

RowResult run_row(const Row& row, const std::vector<std::uint64_t>& seeds, ModelStore& store) {
    RowResult result;
    try {
        for (const std::uint64_t seed : seeds) {
            learning::TrainSettings settings = row.settings;
            settings.seed = seed;
            result.models.push_back(store.model_of(settings));
        }
    } catch (const TrainingStopped&) {
        throw;
    } catch (const Error& error) {
        log_warning(row.name + ": " + error.what());
        result.failure = error.what();
    }
    return result;
}

std::vector<detection::Particles> some_swarms(const dataset::Dataset& data, const learning::TrainSettings& settings,
                                              std::size_t count) {
    const std::vector<std::size_t> test =
        data.part(learning::label_rule_of(settings), learning::split_of(settings), dataset::Part::test);
    std::vector<detection::Particles> swarms;
    for (std::size_t next = 0; next < std::min(count, test.size()); ++next) {
        swarms.push_back(data.particles(test[next * test.size() / std::min(count, test.size())]));
    }
    return swarms;
}

TimingResult run_timing(const Timing& timing, const Plan& plan, const std::vector<RowResult>& rows,
                        const dataset::Dataset& data, const learning::Engine& engine) {
    const auto row = static_cast<std::size_t>(
        std::find_if(plan.rows.begin(), plan.rows.end(), [&](const Row& each) { return each.name == timing.row; }) -
        plan.rows.begin());
    try {
        if (rows[row].models.empty()) {
            throw Error("the row has no model");
        }
        learning::RunOptions options;
        options.device = timing.device;
        const auto model = engine.load(rows[row].models.front().file, options);
        const auto swarms = some_swarms(data, plan.rows[row].settings, plan.timed_samples);
        return {inference_time_ms(*model, swarms, timing.image_file), ""};
    } catch (const Error& error) {
        return {std::numeric_limits<double>::quiet_NaN(), error.what()};
    }
}

std::string yes_or_dash(bool value) { return value ? "yes" : "-"; }

}  // namespace

std::vector<RowResult> run_rows(const Plan& plan, ModelStore& store) {
    std::vector<RowResult> results;
    for (const Row& row : plan.rows) {
        results.push_back(run_row(row, plan.seeds, store));
        log_info(std::to_string(results.size()) + " of " + std::to_string(plan.rows.size()) + " rows: " + row.name);
    }
    return results;
}

std::vector<TimingResult> run_timings(const Plan& plan, const std::vector<RowResult>& rows,
                                      const dataset::Dataset& data, const learning::Engine& engine) {
    std::vector<TimingResult> results;
    for (const Timing& timing : plan.timings) {
        results.push_back(run_timing(timing, plan, rows, data, engine));
    }
    return results;
}

Table accuracy_table(const Plan& plan, const std::vector<RowResult>& results) {
    Table table({{"row"},
                 {"mapping"},
                 {"augmentation"},
                 {"loss"},
                 {"optimizer"},
                 {"swarm"},
                 {"trained on"},
                 {"seeds"},
                 {"accuracy"},
                 {"sd"},
                 {"F1"},
                 {"F1 sd"},
                 {"AUC"},
                 {"paper accuracy"},
                 {"paper F1"},
                 {"note"}});
    for (std::size_t index = 0; index < plan.rows.size(); ++index) {
        const Row& row = plan.rows[index];
        const learning::TrainSettings& settings = row.settings;
        std::vector<double> accuracy;
        std::vector<double> f1;
        std::vector<double> auc;
        for (const TrainedModel& model : results[index].models) {
            accuracy.push_back(model.confusion.accuracy());
            f1.push_back(model.confusion.f1());
            auc.push_back(model.auc);
        }
        table.add_row({row.name, yes_or_dash(settings.image.linear_mapping),
                       yes_or_dash(settings.image.gaussian_augmentation), settings.loss, settings.optimizer.name,
                       Json(settings.image.swarm).get<std::string>(), settings.label + " / " + settings.split,
                       static_cast<std::int64_t>(accuracy.size()), mean_and_sd(accuracy).mean, mean_and_sd(accuracy).sd,
                       mean_and_sd(f1).mean, mean_and_sd(f1).sd, mean_and_sd(auc).mean, row.paper_accuracy,
                       row.paper_f1, results[index].failure});
    }
    return table;
}

Table timing_table(const Plan& plan, const std::vector<TimingResult>& results) {
    Table table({{"row"}, {"device"}, {"image matrix"}, {"time [ms]", 2}, {"paper [ms]", 0}, {"note"}});
    for (std::size_t index = 0; index < plan.timings.size(); ++index) {
        const Timing& timing = plan.timings[index];
        table.add_row({timing.row, timing.device, yes_or_dash(!timing.image_file), results[index].time_ms,
                       timing.paper_ms, results[index].failure});
    }
    return table;
}

}  // namespace ddtool::ablation
