#include "study/compare/runner.hpp"

#include <map>

#include "study/compare/cell_run.hpp"
#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/task_progress.hpp"

namespace ddtool::compare {
namespace {

/// For every cell the first one that is equal to it.
std::vector<std::size_t> first_equals(const std::vector<Cell>& cells) {
    std::map<std::string, std::size_t> first;
    std::vector<std::size_t> firsts;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        firsts.push_back(first.try_emplace(cells[index].id, index).first->second);
    }
    return firsts;
}

}  // namespace

RunOutcome run_cells(const Experiment& experiment, const std::vector<Cell>& cells, ResultStore& store,
                     ThreadPool& threads, const std::string& program) {
    RunOutcome outcome;
    outcome.results.resize(cells.size());
    const std::vector<std::size_t> firsts = first_equals(cells);
    std::vector<std::size_t> missing;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        if (firsts[index] == index) {
            if (auto known = store.load(cells[index])) {
                outcome.results[index] = *known;
            } else {
                missing.push_back(index);
            }
        }
    }
    TaskProgress progress("comparing", "runs", missing.size());
    threads.for_each(missing.size(), [&](std::size_t task, std::size_t /*worker*/) {
        const Cell& cell = cells[missing[task]];
        CellResult& result = outcome.results[missing[task]];
        try {
            result = run_cell(experiment, cell, store, program, [&](double share) { progress.update(task, share); });
        } catch (const OutputError&) {
            throw;
        } catch (const std::exception& error) {
            result.failure = failure_text(error);
        }
        const std::string title = title_of(experiment, cell);
        if (result.failure.empty()) {
            progress.finish(task, title, "done in " + format_duration(result.duration_s));
        } else {
            progress.fail(task, title, result.failure);
        }
    });
    for (std::size_t index = 0; index < cells.size(); ++index) {
        outcome.results[index] = outcome.results[firsts[index]];
    }
    outcome.computed = missing.size();
    return outcome;
}

}  // namespace ddtool::compare
