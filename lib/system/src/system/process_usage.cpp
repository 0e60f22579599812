#include "system/process_usage.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace ddtool {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

constexpr std::uint64_t bytes_per_kilobyte = 1024;
constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

std::uint64_t free_on_machine_bytes() {
    std::ifstream file("/proc/meminfo");
    for (std::string name; file >> name;) {
        std::uint64_t kilobytes = 0;
        if (name == "MemAvailable:" && file >> kilobytes) {
            return kilobytes * bytes_per_kilobyte;
        }
    }
    return unknown;
}

/// The memory limit of the container, from its control group of version 2 or 1; `unknown` if there is none.
std::uint64_t allowed_to_container_bytes() {
    for (const char* path : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::uint64_t bytes = 0;
        if (std::ifstream(path) >> bytes) {
            return bytes;
        }
    }
    return unknown;
}

}  // namespace

ProcessUsage process_usage() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
            usage.ru_maxrss * static_cast<std::int64_t>(bytes_per_kilobyte)};
}

std::uint64_t available_memory_bytes() {
    const std::uint64_t least = std::min(free_on_machine_bytes(), allowed_to_container_bytes());
    return least == unknown ? 0 : least;
}

void return_freed_memory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

}  // namespace ddtool
