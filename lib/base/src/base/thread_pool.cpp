#include "ddtool/base/thread_pool.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace ddtool {
namespace {

/// Polls the condition for a short while, because to wake a sleeping thread takes longer than many a loop does. Other
/// threads that need the processor get it meanwhile.
template <typename Condition>
void await_briefly(const Condition& condition) {
    constexpr int looks = 200;  // about 0.1 ms on an idle processor
    for (int look = 0; look < looks && !condition(); ++look) {
        std::this_thread::yield();
    }
}

}  // namespace

ThreadPool::ThreadPool(std::size_t threads) {
    if (threads == 0) {
        threads = std::max(1U, std::thread::hardware_concurrency());
    }
    try {
        for (std::size_t worker = 1; worker < threads; ++worker) {
            workers_.emplace_back([this, worker] { work(worker); });
        }
    } catch (const std::system_error&) {
        // The system cannot start more threads. Those that exist do all the work, with the same results.
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    start_.notify_all();
    for (std::thread& worker : workers_) {
        worker.join();
    }
}

void ThreadPool::for_each(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) {
    {
        const std::scoped_lock lock(mutex_);
        body_ = &body;
        count_ = count;
        next_ = 0;
        busy_ = workers_.size();
        ++round_;
    }
    start_.notify_all();
    take_indices(0);
    await_briefly([this] { return busy_ == 0; });
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return busy_ == 0; });
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

void ThreadPool::work(std::size_t worker) {
    std::size_t seen = 0;
    while (true) {
        await_briefly([&] { return stop_ || round_ != seen; });
        {
            std::unique_lock lock(mutex_);
            start_.wait(lock, [&] { return stop_ || round_ != seen; });
            if (stop_) {
                return;
            }
            seen = round_;
        }
        take_indices(worker);
        const std::scoped_lock lock(mutex_);
        if (--busy_ == 0) {
            finished_.notify_one();
        }
    }
}

void ThreadPool::take_indices(std::size_t worker) {
    try {
        for (std::size_t index = next_++; index < count_; index = next_++) {
            (*body_)(index, worker);
        }
    } catch (...) {
        next_ = count_;
        const std::scoped_lock lock(mutex_);
        if (!failure_) {
            failure_ = std::current_exception();
        }
    }
}

}  // namespace ddtool
