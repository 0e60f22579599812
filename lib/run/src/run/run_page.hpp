#pragma once

#include <string>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "report/page.hpp"
#include "run/back_end_results.hpp"
#include "run/run_course.hpp"
#include "run/run_summary.hpp"

namespace ddtool {

/// What the report page of a run is made of. The referenced objects must live until the page has been made.
struct RunPageContent {
    std::string command = "ddtool slam";
    std::string log_file;
    std::vector<std::string> warnings;
    const FilterRun& run;
    const MapRaster& map;
    const RunCourse& course;
    const RunSummary& summary;
    const RunCost& cost;
    std::vector<report::Fact> first_facts;     ///< that stand before all others, such as the self-check's verdict
    ImageSettings image;                       ///< how the worst moments are drawn
    const BackEndResults* back_end = nullptr;  ///< null if the run had none
    const Json& settings;                      ///< shown unchanged
    const Json& log;
    const Json& versions;
};

/// Makes the report page of one run of the filter (docs/reports.md): the map with the path coloured by the degree,
/// values over time, the worst moments as images, the errors where the true trajectory is known, and the settings.
report::Page run_page(const RunPageContent& content);

}  // namespace ddtool
