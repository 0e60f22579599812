#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ddtool {

/// A fixed set of workers for loops whose iterations are independent. The calling thread is worker 0.
class ThreadPool {
public:
    /// threads = 0 takes every core. Fewer start where the system gives no more.
    explicit ThreadPool(std::size_t threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] std::size_t size() const { return workers_.size() + 1; }

    /// Calls body(index, worker) for every index in 0..count-1, worker in 0..size()-1; returns when all are done.
    /// The first exception of any iteration is rethrown here. Not to be called from inside a body.
    void for_each(std::size_t count, const std::function<void(std::size_t index, std::size_t worker)>& body);

private:
    void work(std::size_t worker);
    void take_indices(std::size_t worker);

    std::vector<std::thread> workers_;
    std::mutex mutex_;
    std::condition_variable start_;
    std::condition_variable finished_;
    std::atomic<std::size_t> round_ = 0;
    std::atomic<std::size_t> busy_ = 0;
    std::atomic<bool> stop_ = false;
    std::atomic<std::size_t> next_ = 0;
    std::size_t count_ = 0;
    const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
    std::exception_ptr failure_;
};

}  // namespace ddtool
