#include "study/compare/runner.hpp"

#include <chrono>

#include "ddtool/base/error.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "jobs/runner.hpp"
#include "scores/tum_file.hpp"

namespace ddtool::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// Runs the estimator over all frames. Returns the true trajectory, as far as the frames contain it.
Trajectory feed(Estimator& estimator, const DataSource& data, const std::shared_ptr<ScanTruth>& scan_truth,
                CellResult& result, const jobs::OnProgress& on_progress) {
    Trajectory truth;
    const std::unique_ptr<SensorStream> stream = data.open([&](const LogProblem&) { ++result.log_problems; });
    stream->tell_truth(scan_truth);
    while (const std::optional<SensorFrame> frame = stream->next()) {
        estimator.process(*frame);
        if (frame->world_from_robot) {
            truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        }
        ++result.scans;
        on_progress(stream->fraction_read());
    }
    return truth;
}

ScoreFigures score_of(const Trajectory& estimate, const Trajectory& truth, const DataSource& data,
                      const AteOptions& options) {
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
    return figures_of(score);
}

/// Runs the estimator of the cell over all frames, scores the trajectory and saves the result. Throws Error if the run
/// cannot be scored.
CellResult run_cell(const Experiment& experiment, const Cell& cell, ResultStore& store, const std::string& program,
                    const jobs::OnProgress& on_progress) {
    const Clock::time_point start = Clock::now();
    CellResult result;
    result.program = program;
    const auto scan_truth = std::make_shared<ScanTruth>();
    const auto estimator = experiment.contestants[cell.contestant].start(experiment.worlds[cell.world].name(),
                                                                         experiment.seeds[cell.seed], scan_truth);
    Trajectory truth = feed(*estimator, *cell.data, scan_truth, result, on_progress);
    if (!cell.data->reference_file.empty()) {
        truth = read_tum(cell.data->reference_file);
    }
    const Trajectory estimate = estimator->trajectory();
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

}  // namespace

RunOutcome run_cells(const Experiment& experiment, const std::vector<Cell>& cells, ResultStore& store,
                     ThreadPool& threads, const std::string& program) {
    std::vector<jobs::Job<CellResult>> all;
    all.reserve(cells.size());
    for (const Cell& cell : cells) {
        all.push_back({.id = cell.key.id(),
                       .title = title_of(experiment, cell),
                       .find = [&] { return store.load(cell); },
                       .make =
                           [&](const jobs::OnProgress& on_progress) {
                               return run_cell(experiment, cell, store, program, on_progress);
                           },
                       .note = [](const CellResult&) { return "done"; }});
    }
    const jobs::Outcome<CellResult> outcome = jobs::run(all, threads, {"comparing", "runs"});
    RunOutcome runs{{}, outcome.made};
    for (const jobs::Result<CellResult>& result : outcome.results) {
        runs.results.push_back(result.value.value_or(CellResult{}));
        runs.results.back().failure = result.failure;
    }
    return runs;
}

}  // namespace ddtool::compare
