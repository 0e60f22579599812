#pragma once

#include <vector>

#include "report/table.hpp"
#include "study/ablation/runs.hpp"

namespace ddtool::ablation {

/// Our figures beside the paper's.
Table accuracy_table(const Plan& plan, const std::vector<RowResult>& results,
                     const std::vector<judge::Evaluation>& rules);
Table timing_table(const Plan& plan, const std::vector<TimingResult>& results);

}  // namespace ddtool::ablation
