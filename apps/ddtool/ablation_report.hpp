#pragma once

#include <filesystem>
#include <string>

#include "program.hpp"
#include "study/ablation/model_store.hpp"

namespace ddtool {

/// Runs the plan in the file on a data set, prints its tables, and writes them as ablation.md and ablation.json into
/// the folder, beside the trained models. Rows and times that cannot be computed on this machine are reported as
/// skipped.
ExitCode run_ablation(const train::Engine& engine, const std::string& plan_file, const std::filesystem::path& data,
                      const std::filesystem::path& folder, const ablation::Machine& machine, bool as_json);

}  // namespace ddtool
