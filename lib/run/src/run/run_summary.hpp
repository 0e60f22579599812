#pragma once

#include <cstdint>
#include <optional>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"
#include "scores/trajectory_score.hpp"

namespace ddtool {

/// Wall time per update in the filter, in milliseconds.
struct StepTimes {
    double median_ms = 0.0;
    double p99_ms = 0.0;  ///< one update in a hundred took longer
    double most_ms = 0.0;
};

/// What one run of the filter did, for run.json, the printed summary and the report page.
struct RunSummary {
    std::size_t scans = 0;
    std::uint64_t updates = 0;
    std::uint64_t resamplings = 0;
    double duration_s = 0.0;  ///< by the scans' stamps
    double path_m = 0.0;
    double map_width_m = 0.0;
    double map_height_m = 0.0;
    double cell_size_m = 0.0;
    double read_s = 0.0;                    ///< wall time spent on reading the log
    StageTimes stages;                      ///< wall time spent in the filter
    double write_s = 0.0;                   ///< wall time spent on writing the run's files
    std::optional<TrajectoryScore> errors;  ///< empty if the true trajectory is unknown
    std::optional<StepTimes> step;          ///< empty if there was no update
};

RunSummary run_summary(const FilterRun& run, const MapRaster& map, const RunCourse& course, double write_s);

/// The summary in the form of run.json (docs/formats/results.md).
Json to_run_json(const RunSummary& summary);

/// The time and memory that a run took.
struct RunCost {
    std::size_t threads = 0;  ///< as configured; 0 stands for all cores
    double wall_s = 0.0;
    double cpu_s = 0.0;
    std::int64_t peak_memory_bytes = 0;
};
void to_json(Json& json, const RunCost& cost);

/// The seconds spent in each stage, in the order in which the stages follow each other, with their names: {"read_s",
/// ...}.
std::vector<std::pair<std::string, double>> stages_of(const RunSummary& summary);

}  // namespace ddtool
