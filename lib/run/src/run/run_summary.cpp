#include "run/run_summary.hpp"

#include <algorithm>

#include "scores/statistics.hpp"

namespace ddtool {

namespace {

/// The time between the earliest and the latest stamp. These need not be the first and the last one, because the stamps
/// of some old logs step backwards.
double duration_s(const Trajectory& trajectory) {
    if (trajectory.empty()) {
        return 0.0;
    }
    const auto [first, last] =
        std::minmax_element(trajectory.begin(), trajectory.end(),
                            [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
    return 1e-9 * static_cast<double>(last->stamp_ns - first->stamp_ns);
}

std::optional<StepTimes> step_times(const RunCourse& course) {
    std::vector<double> steps_ms;
    for (const UpdateSummary& update : course.updates()) {
        steps_ms.push_back(1e3 * update.step_s);
    }
    if (steps_ms.empty()) {
        return std::nullopt;
    }
    return StepTimes{quantile(steps_ms, 0.5), quantile(steps_ms, 0.99), quantile(steps_ms, 1.0)};
}

}  // namespace

RunSummary run_summary(const FilterRun& run, const MapRaster& map, const RunCourse& course, double write_s) {
    RunSummary summary{.scans = run.trajectory.size(),
                       .updates = run.updates,
                       .resamplings = run.resamplings,
                       .duration_s = duration_s(run.trajectory),
                       .path_m = path_length_m(run.trajectory),
                       .map_width_m = map.width_m(),
                       .map_height_m = map.height_m(),
                       .cell_size_m = map.cell_size_m,
                       .read_s = run.read_s,
                       .stages = run.times,
                       .write_s = write_s,
                       .errors = std::nullopt,
                       .step = step_times(course)};
    if (!run.ground_truth.empty()) {
        summary.errors = score_against(run.trajectory, run.ground_truth);
    }
    return summary;
}

std::vector<std::pair<std::string, double>> stages_of(const RunSummary& summary) {
    const StageTimes& filter = summary.stages;
    return {{"read_s", summary.read_s},    {"prepare_s", filter.prepare_s}, {"match_s", filter.match_s},
            {"detect_s", filter.detect_s}, {"correct_s", filter.correct_s}, {"resample_s", filter.resample_s},
            {"map_s", filter.map_s},       {"write_s", summary.write_s}};
}

Json to_run_json(const RunSummary& summary) {
    Json stages = Json::object();
    for (const auto& [stage, seconds] : stages_of(summary)) {
        stages[stage] = seconds;
    }
    Json json{
        {"scans", summary.scans},
        {"updates", summary.updates},
        {"resamplings", summary.resamplings},
        {"duration_s", summary.duration_s},
        {"path_m", summary.path_m},
        {"map",
         {{"width_m", summary.map_width_m}, {"height_m", summary.map_height_m}, {"cell_size_m", summary.cell_size_m}}},
        {"stages", stages}};
    if (summary.errors) {
        json["errors"] = score_json(*summary.errors);
    }
    json["step_ms"] = nullptr;
    if (summary.step) {
        json["step_ms"] = {
            {"median", summary.step->median_ms}, {"p99", summary.step->p99_ms}, {"most", summary.step->most_ms}};
    }
    return json;
}

void to_json(Json& json, const RunCost& cost) {
    json = {{"threads", cost.threads},
            {"wall_s", cost.wall_s},
            {"cpu_s", cost.cpu_s},
            {"peak_memory_bytes", cost.peak_memory_bytes}};
}

}  // namespace ddtool
