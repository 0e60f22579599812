#pragma once

#include <cstdint>

namespace ddtool {

/// What this process has used so far, all threads together.
struct ProcessUsage {
    double cpu_s = 0.0;
    std::int64_t peak_memory_bytes = 0;  ///< largest resident set
};

ProcessUsage process_usage();

/// The memory in bytes that this process may still take before the system ends it: what is free on the machine, or the
/// limit of the container if that is less. Returns 0 if the system does not tell.
std::uint64_t available_memory_bytes();

/// Returns freed memory to the system at once; the C library would keep small pieces for later use. Call it after
/// something large has ended and before something else large begins, so that the two do not add up.
void return_freed_memory();

}  // namespace ddtool
