#include "dataset/part_runner.hpp"

#include <charconv>
#include <chrono>

#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/process_usage.hpp"
#include "system/task_progress.hpp"

namespace ddtool::dataset {
namespace {

using Clock = std::chrono::steady_clock;

std::optional<std::size_t> number_in(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string note_of(const SnapshotRun& made, Clock::time_point start) {
    return std::to_string(made.samples.size()) + " of " + std::to_string(made.snapshots) + " snapshots in " +
           format_duration(std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace

WorkShare parse_work_share(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = number_in(std::string_view(text).substr(0, slash));
    const auto count = number_in(slash == std::string::npos ? "" : std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count) {
        throw UsageError("--shard " + text + ": expected i/n with i from 1 to n");
    }
    return {*index, *count};
}

std::vector<RunResult> make_parts(const RunPlan& plan, const WorkShare& share, PartStore& store, ThreadPool& threads,
                                  const std::string& program) {
    std::vector<RunResult> results(plan.runs.size());
    std::vector<std::size_t> missing;
    for (std::size_t index = 0; index < plan.runs.size(); ++index) {
        if (share.has(index)) {
            results[index].part = store.find(plan.runs[index]);
            if (!results[index].part) {
                missing.push_back(index);
            }
        }
    }
    TaskProgress progress("building", "runs", missing.size());
    threads.for_each(missing.size(), [&](std::size_t task, std::size_t /*worker*/) {
        const PlannedRun& run = plan.runs[missing[task]];
        RunResult& result = results[missing[task]];
        const Clock::time_point start = Clock::now();
        try {
            const SnapshotRun made = make_run(run, [&](double done) { progress.update(task, done); });
            result.part = store.save(run, made, program);
            progress.finish(task, title_of(plan, run), note_of(made, start));
        } catch (const OutputError&) {
            throw;
        } catch (const std::exception& error) {
            result.failure = failure_text(error);
            progress.fail(task, title_of(plan, run), result.failure);
        }
        return_freed_memory();
    });
    return results;
}

std::vector<RunResult> find_parts(const RunPlan& plan, const PartStore& store) {
    std::vector<RunResult> results;
    std::string first_missing;
    std::size_t missing = 0;
    for (const PlannedRun& run : plan.runs) {
        results.push_back({store.find(run), ""});
        if (!results.back().part && missing++ == 0) {
            first_missing = title_of(plan, run) + " (" + run.entry.id + ")";
        }
    }
    if (missing > 0) {
        throw Error(std::to_string(missing) + " of " + std::to_string(plan.runs.size()) +
                    " parts are missing, the first of " + first_missing + "; expected them from build-dataset --shard");
    }
    return results;
}

}  // namespace ddtool::dataset
