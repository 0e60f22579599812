#pragma once

#include <cstddef>
#include <vector>

#include "base/settings.hpp"
#include "results/map_raster.hpp"
#include "results/run_course.hpp"
#include "slam/filter_run.hpp"

namespace ddtool {

/// A run as the explorer of a page shows it (docs/reports.md).
struct RunExplorer {
    std::vector<std::size_t> updates;  ///< of the course: those that are the explorer's rows
    Json data;
};

/// No more than some thousand rows, however long the run, which has one scan at least.
RunExplorer run_explorer(const FilterRun& run, const MapRaster& map, const RunCourse& course);

}  // namespace ddtool
