#include "compare/runner.hpp"

#include <chrono>
#include <map>
#include <mutex>
#include <numeric>

#include "base/log.hpp"
#include "base/progress.hpp"
#include "compare/cell_run.hpp"

namespace ddtool::compare {
namespace {

/// Progress of many cells at once.
class SharedProgress {
public:
    explicit SharedProgress(std::size_t cells) : shares_(cells, 0.0) {}

    void update(std::size_t index, double share) {
        const std::scoped_lock lock(mutex_);
        done_ += share - shares_[index];
        shares_[index] = share;
        line_.update(fraction(), finished_);
    }

    void finish(std::size_t index, const std::string& title, const CellResult& result) {
        update(index, 1.0);
        const std::scoped_lock lock(mutex_);
        ++finished_;
        const double elapsed_s = std::chrono::duration<double>(Progress::Clock::now() - start_).count();
        const double left_s = elapsed_s * (1.0 - fraction()) / fraction();
        const std::string count = std::to_string(finished_) + " of " + std::to_string(shares_.size());
        if (result.failure.empty()) {
            log_info(title + ": done in " + format_duration(result.duration_s) + "; " + count + ", " +
                     format_duration(left_s) + " left");
        } else {
            log_warning(title + ": failed: " + result.failure + "; " + count);
        }
    }

private:
    [[nodiscard]] double fraction() const { return done_ / static_cast<double>(shares_.size()); }

    std::mutex mutex_;
    std::vector<double> shares_;
    double done_ = 0.0;
    std::size_t finished_ = 0;
    Progress line_{"comparing", "runs"};
    Progress::Clock::time_point start_ = Progress::Clock::now();
};

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
    SharedProgress progress(missing.size());
    threads.for_each(missing.size(), [&](std::size_t task, std::size_t /*worker*/) {
        const Cell& cell = cells[missing[task]];
        CellResult& result = outcome.results[missing[task]];
        try {
            result = run_cell(experiment, cell, store, program, [&](double share) { progress.update(task, share); });
        } catch (const std::exception& error) {
            result.failure = error.what();
        }
        progress.finish(task, title_of(experiment, cell), result);
    });
    for (std::size_t index = 0; index < cells.size(); ++index) {
        outcome.results[index] = outcome.results[firsts[index]];
    }
    outcome.computed = missing.size();
    return outcome;
}

}  // namespace ddtool::compare
