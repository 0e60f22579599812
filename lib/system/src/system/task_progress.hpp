#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "system/progress.hpp"

namespace ddtool {

/// Progress of many tasks that run at the same time: a line that is redrawn, and a log line with the time left for each
/// task that ends. All functions may be called from many threads.
class TaskProgress {
public:
    /// \param what, unit as for Progress; the unit is that of the tasks
    /// \param tasks the number of tasks
    TaskProgress(std::string what, std::string unit, std::size_t tasks)
        : shares_(tasks, 0.0), line_(std::move(what), std::move(unit)) {}

    /// \param share the share of the task that is done, 0..1
    void update(std::size_t task, double share);
    /// The task has succeeded.
    void finish(std::size_t task, const std::string& title, const std::string& note);
    /// The task has failed.
    void fail(std::size_t task, const std::string& title, const std::string& reason);

private:
    void set(std::size_t task, double share);
    [[nodiscard]] std::string count() const;
    [[nodiscard]] double fraction() const { return done_ / static_cast<double>(shares_.size()); }

    std::mutex mutex_;
    std::vector<double> shares_;
    double done_ = 0.0;
    std::size_t finished_ = 0;
    Progress line_;
    Progress::Clock::time_point start_ = Progress::Clock::now();
};

}  // namespace ddtool
