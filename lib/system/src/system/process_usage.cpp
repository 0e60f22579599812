#include "system/process_usage.hpp"

#include <malloc.h>
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

void return_freed_memory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

}  // namespace ddtool
