#include "base/process_usage.hpp"

#include <sys/resource.h>

namespace ddtool {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ProcessUsage process_usage() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    constexpr std::int64_t bytes_per_kilobyte = 1024;
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss * bytes_per_kilobyte};
}

}  // namespace ddtool
