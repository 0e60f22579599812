#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// A picture of the report and the world that it belongs to.
struct Picture {
    std::string title;
    std::string file;  ///< relative to the report
};

/// {"baseline", "seeds", "rows": one a metric, world and contestant; "failures", "programs": builds that computed}.
Json results_json(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results);

/// results.md, results.csv, results.json and report.html (docs/reports.md) in the folder. Returns whether the last,
/// which nothing else depends on, could be written.
bool write_report(const std::filesystem::path& folder, const Experiment& experiment, const std::vector<Cell>& cells,
                  const std::vector<CellResult>& results, const std::vector<Picture>& pictures);

}  // namespace ddtool::compare
