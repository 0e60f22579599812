#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench_plan.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::matcher_bench {

/// Tables for people in Markdown: bias and drift, spread beside the bound, belief.
std::string tables(const std::vector<CaseResult>& results);

/// All figures, lengths in m and angles in rad; a missing figure is null.
Json results_json(const Plan& plan, const std::vector<CaseResult>& results);

/// Bars of bias, drift, and spread over bound, for each world (and lidar) and cell size.
void write_picture(const std::filesystem::path& path, const std::vector<CaseResult>& results);

}  // namespace ddtool::matcher_bench
