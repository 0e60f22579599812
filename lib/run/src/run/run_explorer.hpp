#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// The data of a run that the interactive explorer of a report page shows (docs/reports.md).
struct RunExplorer {
    std::vector<std::size_t> updates;  ///< positions in course.updates() of the updates that are the explorer's rows
    Json data;
};

/// Keeps at most a few thousand rows, however long the run is. The run must have at least one scan.
RunExplorer run_explorer(const FilterRun& run, const MapRaster& map, const RunCourse& course);

}  // namespace ddtool
