#pragma once

#include <string>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "report/page.hpp"
#include "run/run_course.hpp"
#include "run/run_report.hpp"

namespace ddtool {

/// What the page of a run is made of. References must live until the page is made.
struct RunPageContent {
    std::string log_file;
    std::vector<std::string> warnings;
    const FilterRun& run;
    const MapRaster& map;
    const RunCourse& course;
    const RunReport& report;
    const CostReport& cost;
    ImageSettings image;   ///< how the worst moments are drawn
    const Json& settings;  ///< shown as they are
    const Json& log;
    const Json& versions;
};

/// A run of the filter to look at (docs/reports.md): the map with the path coloured by the degree, time lines, the
/// worst moments as images, errors where the truth is known, settings.
html::Page run_page(const RunPageContent& content);

}  // namespace ddtool
