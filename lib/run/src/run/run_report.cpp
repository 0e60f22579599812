#include "run/run_report.hpp"

#include <algorithm>

#include "ddtool/system/json_struct.hpp"
#include "scores/statistics.hpp"
#include "scores/trajectory_score.hpp"

namespace ddtool {

DDTOOL_JSON_STRUCT(StageTimes, prepare_s, match_s, detect_s, correct_s, resample_s, map_s)

namespace {

/// From the earliest to the latest stamp: old logs jitter backwards.
double duration_s(const Trajectory& trajectory) {
    if (trajectory.empty()) {
        return 0.0;
    }
    const auto [first, last] =
        std::minmax_element(trajectory.begin(), trajectory.end(),
                            [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
    return 1e-9 * static_cast<double>(last->stamp_ns - first->stamp_ns);
}

}  // namespace

Json step_time_report(const RunCourse& course) {
    const std::vector<double>& steps = course.step_s();
    if (steps.empty()) {
        return nullptr;
    }
    const auto ms_at = [&](double fraction) { return 1e3 * quantile(steps, fraction); };
    return {{"median", ms_at(0.5)}, {"p99", ms_at(0.99)}, {"most", ms_at(1.0)}};
}

Json run_report(const FilterRun& run, const MapRaster& map) {
    Json stages{{"read_s", run.read_s}};
    stages.update(Json(run.times));
    Json report{{"scans", run.trajectory.size()},
                {"updates", run.updates},
                {"resamplings", run.resamplings},
                {"duration_s", duration_s(run.trajectory)},
                {"path_m", path_length_m(run.trajectory)},
                {"map", {{"width_m", map.width_m()}, {"height_m", map.height_m()}, {"cell_size_m", map.cell_size_m}}},
                {"stages", stages}};
    if (!run.ground_truth.empty()) {
        report["errors"] = score_json(score_against(run.trajectory, run.ground_truth));
    }
    return report;
}

}  // namespace ddtool
