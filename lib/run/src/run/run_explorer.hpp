#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// A run as the explorer of a page shows it (docs/reports.md).
struct RunExplorer {
    std::vector<std::size_t> updates;  ///< of the course: those that are the explorer's rows
    Json data;
};

/// No more than some thousand rows, however long the run, which has one scan at least.
RunExplorer run_explorer(const FilterRun& run, const MapRaster& map, const RunCourse& course);

}  // namespace ddtool
