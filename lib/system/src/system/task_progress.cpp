#include "system/task_progress.hpp"

#include <algorithm>

#include "system/log.hpp"

namespace ddtool {

void TaskProgress::update(std::size_t task, double share) {
    const std::scoped_lock lock(mutex_);
    set(task, share);
    line_.update(fraction(), finished_);
}

void TaskProgress::finish(std::size_t task, const std::string& title, const std::string& note) {
    const std::scoped_lock lock(mutex_);
    set(task, 1.0);
    ++finished_;
    const double elapsed_s = std::chrono::duration<double>(Progress::Clock::now() - start_).count();
    const double left_s = std::max(0.0, elapsed_s * (1.0 - fraction()) / fraction());  // fraction() may round above 1
    log_info(title + ": " + note + "; " + count() + ", " + format_duration(left_s) + " left");
}

void TaskProgress::fail(std::size_t task, const std::string& title, const std::string& reason) {
    const std::scoped_lock lock(mutex_);
    set(task, 1.0);
    ++finished_;
    log_warning(title + ": failed: " + reason + "; " + count());
}

void TaskProgress::set(std::size_t task, double share) {
    done_ += share - shares_[task];
    shares_[task] = share;
}

std::string TaskProgress::count() const { return std::to_string(finished_) + " of " + std::to_string(shares_.size()); }

}  // namespace ddtool
