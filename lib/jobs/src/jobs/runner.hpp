#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/base/thread_pool.hpp"

namespace ddtool::jobs {

/// Thrown when the user has asked to stop (Ctrl-C, SIGTERM). Results that are finished have been stored.
class Stopped : public Error {
public:
    Stopped() : Error("stopped; the same command goes on where it was") {}
};

/// Receives the share of the job that is done, in 0..1. Throws Stopped when the user has asked to stop; a job must not
/// catch it.
using OnProgress = std::function<void(double share)>;

/// Describes a result that is wanted, how to find it, and how to make it.
template <typename Value>
struct Job {
    std::string id;     ///< of the key; jobs with the same id have the same result, which is made only once
    std::string title;  ///< for messages
    std::function<std::optional<Value>()> find;                ///< the stored result; nullopt if there is none
    std::function<Value(const OnProgress& on_progress)> make;  ///< makes and stores the result; may throw
    std::function<std::string(const Value&)> note;             ///< describes the result in a few words
};

template <typename Value>
struct Result {
    std::optional<Value> value;
    std::string failure;  ///< why there is no value; empty if there is one
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

/// The same as Job and run(), without the type of the values: the functions keep the results themselves.
struct AnyJob {
    std::string id;
    std::string title;
    std::function<bool()> find;                          ///< whether the result is stored
    std::function<std::string(const OnProgress&)> make;  ///< makes the result and returns the note
};
struct AnyOutcome {
    std::vector<std::size_t> first_equals;  ///< for each job, the first one with its id, which alone was run
    std::vector<std::string> failures;      ///< one for each job
    std::size_t made = 0;
};
AnyOutcome run_any(const std::vector<AnyJob>& jobs, ThreadPool& threads, const Wording& wording);

/// Returns a result for every job: the stored one or, if there is none, a new one. Jobs run in parallel, each on one
/// thread of the pool. A job that fails does not stop the others; nothing is stored for it, so it is tried again next
/// time. Throws OutputError if results cannot be written, and Stopped when the user has asked to stop.
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
