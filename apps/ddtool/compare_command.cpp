#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "detectors.hpp"
#include "output_folder.hpp"
#include "study/compare/report.hpp"
#include "study/compare/result_tables.hpp"
#include "study/compare/world_pictures.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"
#include "system/progress.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;

struct CompareRequest {
    std::string folder;
    std::size_t threads = 0;
    bool as_json = false;
};

/// Warns of stored results that another build has computed, because they may differ from what this build would compute.
void warn_of_other_builds(const std::vector<compare::CellResult>& results) {
    const auto others = std::count_if(results.begin(), results.end(), [](const compare::CellResult& result) {
        return result.failure.empty() && result.program != program_version();
    });
    if (others > 0) {
        log_warning(std::to_string(others) + " of " + std::to_string(results.size()) +
                    " results were computed by another build; another --out computes them anew");
    }
}

/// Returns whether all runs were scored and nothing in their logs was skipped. Otherwise it prints what is missing.
bool all_runs_scored(const std::vector<compare::CellResult>& results) {
    const auto failed = std::count_if(results.begin(), results.end(),
                                      [](const compare::CellResult& result) { return !result.failure.empty(); });
    const auto damaged = std::count_if(results.begin(), results.end(),
                                       [](const compare::CellResult& result) { return result.log_problems > 0; });
    if (failed > 0) {
        log_warning(std::to_string(failed) + " of " + std::to_string(results.size()) + " runs failed");
    }
    if (damaged > 0) {
        log_warning(std::to_string(damaged) + " runs used a log of which something was skipped: see ddtool info");
    }
    return failed == 0 && damaged == 0;
}

/// Whether a comparison in the folder was stopped. What it has computed is not computed again.
bool is_unfinished_comparison(const std::filesystem::path& folder) {
    return is_folder(folder / "cells") && !std::filesystem::exists(folder / "results.json");
}

ExitCode run_comparison(const CompareRequest& request, const Json& settings) {
    const Clock::time_point start = Clock::now();
    const compare::Experiment experiment = compare::experiment_from_json(settings, all_detectors());
    const std::vector<compare::Cell> cells = compare::cells_of(experiment);
    const OutputFolder output(request.folder, "compare", is_unfinished_comparison);
    const std::filesystem::path& folder = output.path();
    compare::ResultStore store(folder);
    ThreadPool threads(request.threads);
    const auto [results, computed] = compare::run_cells(experiment, cells, store, threads, program_version());
    log_info("drawing");
    const std::vector<compare::Picture> pictures =
        compare::draw_worlds(folder, experiment, cells, results, store, threads);
    const bool has_page = compare::write_report(folder, experiment, cells, results, pictures);
    if (request.as_json) {
        std::cout << compare::results_json(experiment, cells, results).dump(2) << '\n';
    } else {
        const std::vector<compare::Summary> summaries = compare::summaries_of(experiment, cells, results);
        const Table paper = compare::paper_table(experiment, summaries);
        std::cout << compare::overview_table(experiment, summaries).text()
                  << (paper.empty() ? "" : "\n" + paper.text());
    }
    warn_of_other_builds(results);
    log_info(std::to_string(computed) + " of " + std::to_string(cells.size()) + " runs computed, " +
             format_duration(std::chrono::duration<double>(Clock::now() - start).count()) + " in all; report in " +
             (folder / "report.html").string());
    return all_runs_scored(results) && has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace

Command compare_command() {
    const auto request = std::make_shared<CompareRequest>();
    return {.name = "compare",
            .summary = "Methods on worlds over seeds: a table with spread and significance, and pictures",
            .example = "ddtool compare --config configs/compare/quick.json --out out/quick",
            .settings = compare::default_experiment_json(),
            .options =
                {
                    {"--out", &request->folder,
                     "Folder for the results, where finished runs are not run again; if not given, the new one "
                     "'compare'",
                     "DIR"},
                    {"--threads", &request->threads, "Runs at the same time; 0 is one a core"},
                    {"--json", &request->as_json, "Print JSON instead of a table"},
                },
            .run = [request](const Json& settings) { return run_comparison(*request, settings); }};
}

}  // namespace ddtool
