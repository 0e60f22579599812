#pragma once

#include <string>
#include <vector>

#include "base/settings.hpp"
#include "html/page.hpp"
#include "imaging/image_settings.hpp"
#include "results/map_raster.hpp"
#include "results/run_course.hpp"
#include "slam/filter_run.hpp"

namespace ddtool {

/// A run of the filter to look at (docs/reports.md): the map with the path coloured by the degree, time lines, the
/// worst moments as images by `image`, errors where the truth is known, settings. `report` is the content of run.json.
html::Page run_page(const Json& report, const std::vector<std::string>& warnings, const FilterRun& run,
                    const MapRaster& map, const RunCourse& course, const ImageSettings& image);

}  // namespace ddtool
