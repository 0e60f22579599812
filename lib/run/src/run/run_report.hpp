#pragma once

#include <cstdint>
#include <optional>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"
#include "scores/trajectory_score.hpp"

namespace ddtool {

/// Wall time of an update in the filter, in milliseconds.
struct StepTimes {
    double median_ms = 0.0;
    double p99_ms = 0.0;  ///< one in a hundred took longer
    double most_ms = 0.0;
};

/// What one run of the filter did: for run.json, the summary and the page.
struct RunReport {
    std::size_t scans = 0;
    std::uint64_t updates = 0;
    std::uint64_t resamplings = 0;
    double duration_s = 0.0;  ///< by the scans' stamps
    double path_m = 0.0;
    double map_width_m = 0.0;
    double map_height_m = 0.0;
    double cell_size_m = 0.0;
    double read_s = 0.0;                    ///< wall time in the log
    StageTimes stages;                      ///< wall time in the filter
    double write_s = 0.0;                   ///< wall time in the run's files
    std::optional<TrajectoryScore> errors;  ///< where the truth is known
    std::optional<StepTimes> step;          ///< where there was an update
};

RunReport run_report(const FilterRun& run, const MapRaster& map, const RunCourse& course, double write_s);

/// As run.json has it (docs/formats/results.md).
Json to_run_json(const RunReport& report);

/// What a run cost.
struct CostReport {
    std::size_t threads = 0;  ///< as asked for; 0 is every core
    double wall_s = 0.0;
    double cpu_s = 0.0;
    std::int64_t peak_memory_bytes = 0;
};
void to_json(Json& json, const CostReport& cost);

/// Seconds spent in each stage, in the order in which they follow each other: {"read_s", ...}.
std::vector<std::pair<std::string, double>> stages_of(const RunReport& report);

}  // namespace ddtool
