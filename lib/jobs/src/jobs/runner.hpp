#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/base/thread_pool.hpp"

namespace ddtool::jobs {

/// Thrown when the user asked to stop (Ctrl-C, SIGTERM). Finished results are stored.
class Stopped : public Error {
public:
    Stopped() : Error("stopped; the same command goes on where it was") {}
};

/// Receives the share of the job that is done, in 0..1. Throws Stopped when the user asked to stop; do not catch it.
using OnProgress = std::function<void(double share)>;

/// A result that is wanted.
template <typename Value>
struct Job {
    std::string id;     ///< of its key: jobs of the same id have the same result, which is made once
    std::string title;  ///< for messages
    std::function<std::optional<Value>()> find;                ///< the stored result; nullopt: it has to be made
    std::function<Value(const OnProgress& on_progress)> make;  ///< makes and stores it; throws what keeps it from that
    std::function<std::string(const Value&)> note;             ///< describes the result in a few words
};

template <typename Value>
struct Result {
    std::optional<Value> value;
    std::string failure;  ///< why there is no value; empty: there is
};

template <typename Value>
struct Outcome {
    std::vector<Result<Value>> results;  ///< one for each job
    std::size_t made = 0;                ///< jobs that were run, including those that failed
};

/// What messages and the progress line call the work, such as "comparing" and "runs".
struct Wording {
    std::string doing;
    std::string unit;
};

/// What run() does, for jobs that keep their results themselves.
struct AnyJob {
    std::string id;
    std::string title;
    std::function<bool()> find;                          ///< whether the result is there
    std::function<std::string(const OnProgress&)> make;  ///< gives the note
};
struct AnyOutcome {
    std::vector<std::size_t> first_equals;  ///< for each job the first of the same id, which alone was run
    std::vector<std::string> failures;      ///< one for each job
    std::size_t made = 0;
};
AnyOutcome run_any(const std::vector<AnyJob>& jobs, ThreadPool& threads, const Wording& wording);

/// Gives every job a result: the stored one, or else a new one. Jobs run in parallel, each on one thread of the pool.
/// One that fails does not stop the others, and as nothing is stored of it, it is tried again next time. Throws
/// OutputError where results cannot be written, and Stopped when the user asked to stop.
template <typename Value>
Outcome<Value> run(const std::vector<Job<Value>>& jobs, ThreadPool& threads, const Wording& wording) {
    Outcome<Value> outcome;
    outcome.results.resize(jobs.size());
    std::vector<AnyJob> each;
    each.reserve(jobs.size());
    for (std::size_t index = 0; index < jobs.size(); ++index) {
        const Job<Value>& job = jobs[index];
        std::optional<Value>& value = outcome.results[index].value;
        each.push_back({job.id, job.title, [&] { return (value = job.find()).has_value(); },
                        [&](const OnProgress& on_progress) {
                            value = job.make(on_progress);
                            return job.note(*value);
                        }});
    }
    const AnyOutcome any = run_any(each, threads, wording);
    for (std::size_t index = 0; index < jobs.size(); ++index) {
        outcome.results[index].failure = any.failures[any.first_equals[index]];
        outcome.results[index].value = outcome.results[any.first_equals[index]].value;
    }
    outcome.made = any.made;
    return outcome;
}

}  // namespace ddtool::jobs
