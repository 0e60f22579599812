#pragma once

#include <string>
#include <vector>

#include "jobs/runner.hpp"
#include "study/ablation/model_store.hpp"
#include "study/ablation/plan.hpp"

namespace ddtool::ablation {

/// What the seeds of a row reached.
struct RowResult {
    std::vector<TrainedModel> models;  ///< one for each seed that could be trained
    std::string failure;               ///< why the others could not; empty: all could
};

struct TimingResult {
    double time_ms = 0.0;
    std::string failure;
};

/// Trains what is missing, row by row, as jobs::run() does.
std::vector<RowResult> run_rows(const Plan& plan, const ModelStore& store);

/// Of the first seed's models; what this machine cannot run says so.
std::vector<TimingResult> run_timings(const Plan& plan, const std::vector<RowResult>& rows,
                                      const dataset::Dataset& data, const train::Engine& engine);

}  // namespace ddtool::ablation
