#pragma once

#include <string>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "report/page.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// A run of the filter to look at (docs/reports.md): the map with the path coloured by the degree, time lines, the
/// worst moments as images by `image`, errors where the truth is known, settings. `report` is the content of run.json.
html::Page run_page(const Json& report, const std::vector<std::string>& warnings, const FilterRun& run,
                    const MapRaster& map, const RunCourse& course, const ImageSettings& image);

}  // namespace ddtool
