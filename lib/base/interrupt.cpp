#include "base/interrupt.hpp"

#include <csignal>

namespace ddtool {
namespace {

volatile std::sig_atomic_t requested = 0;

void request(int signal) {
    requested = 1;
    std::signal(signal, SIG_DFL);
}

void set_handlers(void (*handler)(int)) {
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
}

}  // namespace

InterruptRequest::InterruptRequest() {
    requested = 0;
    set_handlers(request);
}

InterruptRequest::~InterruptRequest() { set_handlers(SIG_DFL); }

bool InterruptRequest::made() const { return requested != 0; }

}  // namespace ddtool
