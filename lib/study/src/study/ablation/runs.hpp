#pragma once

#include <string>
#include <vector>

#include "jobs/runner.hpp"
#include "study/ablation/model_store.hpp"
#include "study/ablation/plan.hpp"

namespace ddtool::ablation {

/// The trained models of a row, over its seeds.
struct RowResult {
    std::vector<TrainedModel> models;  ///< one for each seed that could be trained
    std::string failure;               ///< why the others could not be trained; empty: all were trained
};

struct TimingResult {
    double time_ms = 0.0;
    std::string failure;
};

/// Fits and tests the rules. Throws UsageError for a rule that does not exist.
std::vector<judge::Evaluation> run_rules(const Plan& plan, const dataset::Dataset& data);

/// Trains the models that the store lacks, row by row, as jobs::run() does.
std::vector<RowResult> run_rows(const Plan& plan, const ModelStore& store);

/// Times the models of the first seed. A timing that this machine cannot run has its `failure` set.
std::vector<TimingResult> run_timings(const Plan& plan, const std::vector<RowResult>& rows,
                                      const dataset::Dataset& data, const train::Engine& engine);

}  // namespace ddtool::ablation
