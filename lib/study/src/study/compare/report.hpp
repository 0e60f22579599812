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

/// The results as JSON: {"baseline", "seeds", "rows": one for each metric, world and contestant; "paper", as
/// paper_table(), "failures", "programs": the builds of ddtool that computed the results}.
Json results_json(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results);

/// Writes results.md, results.csv, results.json and report.html (docs/reports.md) into the folder. Returns whether
/// report.html, which nothing else depends on, could be written.
bool write_report(const std::filesystem::path& folder, const Experiment& experiment, const std::vector<Cell>& cells,
                  const std::vector<CellResult>& results, const std::vector<Picture>& pictures);

}  // namespace ddtool::compare
