#include "jobs/runner.hpp"

#include <chrono>
#include <map>

#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/interrupt.hpp"
#include "system/process_usage.hpp"
#include "system/task_progress.hpp"

namespace ddtool::jobs {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::size_t> first_equals(const std::vector<AnyJob>& jobs) {
    std::map<std::string, std::size_t> first;
    std::vector<std::size_t> firsts;
    for (std::size_t index = 0; index < jobs.size(); ++index) {
        firsts.push_back(first.try_emplace(jobs[index].id, index).first->second);
    }
    return firsts;
}

}  // namespace

AnyOutcome run_any(const std::vector<AnyJob>& jobs, ThreadPool& threads, const Wording& wording) {
    AnyOutcome outcome{first_equals(jobs), std::vector<std::string>(jobs.size()), 0};
    std::vector<std::size_t> missing;
    for (std::size_t index = 0; index < jobs.size(); ++index) {
        if (outcome.first_equals[index] == index && !jobs[index].find()) {
            missing.push_back(index);
        }
    }
    const InterruptRequest interrupt;
    const auto stop_if_asked = [&] {
        if (interrupt.made()) {
            throw Stopped();
        }
    };
    TaskProgress progress(wording.doing, wording.unit, missing.size());
    threads.for_each(missing.size(), [&](std::size_t task, std::size_t /*worker*/) {
        const AnyJob& job = jobs[missing[task]];
        const Clock::time_point start = Clock::now();
        stop_if_asked();
        try {
            const std::string note = job.make([&](double share) {
                stop_if_asked();
                progress.update(task, share);
            });
            const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
            progress.finish(task, job.title, note + " in " + format_duration(elapsed_s));
        } catch (const OutputError&) {
            throw;
        } catch (const Stopped&) {
            throw;
        } catch (const std::exception& error) {
            outcome.failures[missing[task]] = failure_text(error);
            progress.fail(task, job.title, outcome.failures[missing[task]]);
        }
        return_freed_memory();
    });
    stop_if_asked();
    outcome.made = missing.size();
    return outcome;
}

}  // namespace ddtool::jobs
