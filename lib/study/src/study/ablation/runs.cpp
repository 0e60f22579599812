#include "study/ablation/runs.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "ddtool/base/error.hpp"
#include "study/ablation/inference_time.hpp"
#include "study/judge/simple_rules.hpp"

namespace ddtool::ablation {
namespace {

std::string note_of(const TrainedModel& model) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "accuracy %.3f", model.confusion.accuracy());
    return text.data();
}

/// One job for each seed of each row, in the order of the rows.
std::vector<jobs::Job<TrainedModel>> trainings_of(const Plan& plan, const ModelStore& store) {
    std::vector<jobs::Job<TrainedModel>> all;
    for (const Row& row : plan.rows) {
        for (const std::uint64_t seed : plan.seeds) {
            train::TrainSettings settings = row.settings;
            settings.seed = seed;
            all.push_back({.id = store.key_of(settings).id(),
                           .title = row.name + " / seed " + std::to_string(seed),
                           .find = [&store, settings] { return store.find(settings); },
                           .make = [&store, settings](const jobs::OnProgress&) { return store.make(settings); },
                           .note = note_of});
        }
    }
    return all;
}

std::vector<judge::Particles> some_swarms(const dataset::Dataset& data, const train::TrainSettings& settings,
                                          std::size_t count) {
    const std::vector<std::size_t> test =
        data.part(train::label_rule_of(settings), train::split_of(settings), dataset::Part::test);
    std::vector<judge::Particles> swarms;
    for (std::size_t next = 0; next < std::min(count, test.size()); ++next) {
        swarms.push_back(data.particles(test[next * test.size() / std::min(count, test.size())]));
    }
    return swarms;
}

TimingResult run_timing(const Timing& timing, const Plan& plan, const std::vector<RowResult>& rows,
                        const dataset::Dataset& data, const train::Engine& engine) {
    try {
        if (rows[timing.row].models.empty()) {
            throw Error("the row has no model");
        }
        train::RunOptions options;
        options.device = timing.device;
        const auto model = engine.load(rows[timing.row].models.front().file, options);
        const auto swarms = some_swarms(data, plan.rows[timing.row].settings, plan.timed_samples);
        return {inference_time_ms(*model, swarms, timing.image_file), ""};
    } catch (const Error& error) {
        return {std::numeric_limits<double>::quiet_NaN(), error.what()};
    }
}

}  // namespace

std::vector<judge::Evaluation> run_rules(const Plan& plan, const dataset::Dataset& data) {
    const train::TrainSettings& settings = plan.rows.front().settings;
    const judge::Task task{.label = train::label_rule_of(settings), .split = train::split_of(settings)};
    const std::vector<judge::Detector> fitted = judge::fitted_rules(data, task.label, task.split);
    std::vector<judge::Evaluation> results;
    for (const RuleRow& row : plan.rules) {
        const auto found = std::ranges::find_if(
            fitted, [&](const judge::Detector& rule) { return rule.name == row.rule && rule.swarm == row.swarm; });
        if (found == fitted.end()) {
            throw UsageError("rules: no rule '" + row.rule + "' of the swarm '" + row.swarm +
                             "'; docs/evaluation.md lists them");
        }
        results.push_back(judge::evaluate(data, *found, task));
    }
    return results;
}

std::vector<RowResult> run_rows(const Plan& plan, const ModelStore& store) {
    ThreadPool one(1);  // one training at a time, because each of them uses all cores
    const auto trained = jobs::run(trainings_of(plan, store), one, {"training", "networks"}).results;
    std::vector<RowResult> rows;
    for (std::size_t row = 0; row < plan.rows.size(); ++row) {
        RowResult& result = rows.emplace_back();
        for (std::size_t seed = 0; seed < plan.seeds.size(); ++seed) {
            const jobs::Result<TrainedModel>& each = trained[row * plan.seeds.size() + seed];
            if (each.value) {
                result.models.push_back(*each.value);
            } else if (result.failure.empty()) {
                result.failure = each.failure;
            }
        }
    }
    return rows;
}

std::vector<TimingResult> run_timings(const Plan& plan, const std::vector<RowResult>& rows,
                                      const dataset::Dataset& data, const train::Engine& engine) {
    std::vector<TimingResult> results;
    for (const Timing& timing : plan.timings) {
        results.push_back(run_timing(timing, plan, rows, data, engine));
    }
    return results;
}

}  // namespace ddtool::ablation
