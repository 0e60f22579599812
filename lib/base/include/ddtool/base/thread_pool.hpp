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

/// A fixed set of threads for loops whose iterations do not depend on each other. The calling thread works as worker 0.
/// One thread at a time may use a pool.
class ThreadPool {
public:
    /// \param threads the number of threads, including the calling one; 0 is one per core
    /// If the system cannot start that many, the pool has fewer; results do not depend on the number.
    explicit ThreadPool(std::size_t threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] std::size_t size() const { return workers_.size() + 1; }

    /// Calls body(index, worker) once for every index in 0..count-1, from several threads at the same time, and returns
    /// when all calls have ended. `worker` is in 0..size()-1, and two calls that run at the same time have different
    /// workers. If calls throw, the first exception is rethrown here. Must not be called from inside a body.
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
