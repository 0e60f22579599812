#pragma once

#include <filesystem>
#include <string>

#include "program.hpp"
#include "study/ablation/model_store.hpp"
#include "study/ablation/plan.hpp"

namespace ddtool {

/// The name of the paper's plan at the size that this machine can train, as --ablation without a value stands for it.
inline constexpr const char* reduced_plan_name = "reduced";

/// Reads the plan in a file, or one of those inside the program, "paper" and reduced_plan_name. Tells on stderr how the
/// latter was reduced for the machine. Throws UsageError.
ablation::Plan read_ablation_plan(const std::string& name, const ablation::Machine& machine);

/// Runs the plan of that name on a data set, prints its tables, and writes them as ablation.md and ablation.json into
/// the folder, beside the trained models. Rows and times that cannot be computed on this machine are reported as
/// skipped.
ExitCode run_ablation(const train::Engine& engine, const std::string& plan_name, const ablation::Plan& plan,
                      const std::filesystem::path& data, const std::filesystem::path& folder,
                      const ablation::Machine& machine, bool as_json);

}  // namespace ddtool
