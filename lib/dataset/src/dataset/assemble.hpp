#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/parts.hpp"

namespace ddtool::dataset {

/// Labels the samples of the parts, chooses and splits them, and writes shards and manifest into the folder, where an
/// older data set is replaced. The label rules are applied here, so that another threshold does not require the runs to
/// be repeated. Memory grows by 216 bytes per candidate, not with the particles. Returns the manifest. Throws Error.
Manifest assemble(const std::filesystem::path& folder, const Json& settings, const RunPlan& plan,
                  const std::vector<RunResult>& results, const std::string& program);

}  // namespace ddtool::dataset
