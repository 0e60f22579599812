#pragma once

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// What one run of the filter did, for run.json: counts, the span of time by the scans' stamps, the path's length, the
/// map's size, wall time a stage, and, where the truth is known, the trajectory's errors (score_json()).
Json run_report(const FilterRun& run, const MapRaster& map);

/// For run.json: wall time of an update in the filter, in milliseconds: `median`, `p99` (one in a hundred took longer)
/// and `most`; null where there was none.
Json step_time_report(const RunCourse& course);

}  // namespace ddtool
