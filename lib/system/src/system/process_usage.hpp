#pragma once

#include <cstdint>

namespace ddtool {

/// What this process has used so far, all threads together.
struct ProcessUsage {
    double cpu_s = 0.0;
    std::int64_t peak_memory_bytes = 0;  ///< largest resident set
};

ProcessUsage process_usage();

/// Gives memory that was freed back to the system at once. Worth a call after something large has ended and before
/// something else large begins, so that the two do not add up; the C library would keep small pieces for itself.
void return_freed_memory();

}  // namespace ddtool
