#pragma once

#include <string>
#include <vector>

#include "report/table.hpp"
#include "study/ablation/model_store.hpp"
#include "study/ablation/plan.hpp"

namespace ddtool::ablation {

/// What the seeds of a row reached, or why it could not be run.
struct RowResult {
    std::vector<TrainedModel> models;  ///< one a seed
    std::string failure;
};

struct TimingResult {
    double time_ms = 0.0;
    std::string failure;
};

/// Trains what is missing, row by row. A row that fails does not stop the others.
std::vector<RowResult> run_rows(const Plan& plan, ModelStore& store);

/// Of the first seed's models; what this machine cannot run says so.
std::vector<TimingResult> run_timings(const Plan& plan, const std::vector<RowResult>& rows,
                                      const dataset::Dataset& data, const learning::Engine& engine);

/// Our figures beside the paper's.
Table accuracy_table(const Plan& plan, const std::vector<RowResult>& results);
Table timing_table(const Plan& plan, const std::vector<TimingResult>& results);

}  // namespace ddtool::ablation
