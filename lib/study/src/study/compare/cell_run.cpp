#include "study/compare/cell_run.hpp"

#include <chrono>

#include "ddtool/base/error.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "scores/trajectory_score.hpp"
#include "scores/tum_file.hpp"

namespace ddtool::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// Feeds the method; gives back what the frames say of the truth.
Trajectory feed(Method& method, const DataSource& data, const std::shared_ptr<ScanTruth>& scan_truth,
                CellResult& result, const std::function<void(double)>& on_progress) {
    Trajectory truth;
    const std::unique_ptr<SensorStream> stream = data.open([&](const LogProblem&) { ++result.log_problems; });
    stream->tell_truth(scan_truth);
    while (const std::optional<SensorFrame> frame = stream->next()) {
        method.process(*frame);
        if (frame->world_from_robot) {
            truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        }
        ++result.scans;
        on_progress(stream->fraction_read());
    }
    return truth;
}

Json score_of(const Trajectory& estimate, const Trajectory& truth, const DataSource& data, const AteOptions& options) {
    TrajectoryScore score;
    if (!truth.empty()) {
        score = score_against(estimate, truth, {.ate = options, .rpe_delta = {}});
    }
    if (!data.relations_file.empty()) {
        const std::vector<Relation> relations = read_relations(data.relations_file);
        score.relations = score_relations(estimate, relations, options.max_time_difference_s);
        if (score.relations->skipped == relations.size()) {
            throw Error(data.relations_file + ": none of its relations has both times in the trajectory");
        }
    }
    if (!score.absolute && !score.relations) {
        throw Error("no truth to compare with: expected ground truth in the log, a reference or relations");
    }
    return score_json(score);
}

}  // namespace

CellResult run_cell(const Experiment& experiment, const Cell& cell, ResultStore& store, const std::string& program,
                    const std::function<void(double)>& on_progress) {
    const Clock::time_point start = Clock::now();
    CellResult result;
    result.program = program;
    const auto scan_truth = std::make_shared<ScanTruth>();
    const auto method = experiment.methods[cell.method].start(experiment.worlds[cell.world].name(),
                                                              experiment.seeds[cell.seed], scan_truth);
    Trajectory truth = feed(*method, *cell.data, scan_truth, result, on_progress);
    if (!cell.data->reference_file.empty()) {
        truth = read_tum(cell.data->reference_file);
    }
    const Trajectory estimate = method->trajectory();
    if (estimate.empty()) {
        throw Error("no poses in the trajectory");
    }
    result.score = score_of(estimate, truth, *cell.data, experiment.score);
    result.duration_s = std::chrono::duration<double>(Clock::now() - start).count();
    if (!truth.empty()) {
        store.save_truth(cell, truth);
    }
    store.save(cell, result, estimate);
    return result;
}

}  // namespace ddtool::compare
