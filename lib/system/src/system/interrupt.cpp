#include "system/interrupt.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace ddtool {
namespace {

// Atomic rather than std::sig_atomic_t, because other threads read it while one thread handles the signal.
std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "else a signal handler must not write it");

std::atomic<int> alive = 0;

void request(int signal) {
    requested = true;
    std::signal(signal, SIG_DFL);
}

void set_handlers(void (*handler)(int)) {
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
}

}  // namespace

InterruptRequest::InterruptRequest() {
    if (alive++ == 0) {
        requested = false;
        set_handlers(request);
    }
}

InterruptRequest::~InterruptRequest() {
    if (--alive == 0) {
        set_handlers(SIG_DFL);
    }
}

bool InterruptRequest::made() const { return requested; }

void InterruptRequest::wait() const {
    while (!made()) {  // polls, because a signal handler must not notify a condition variable
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

}  // namespace ddtool
