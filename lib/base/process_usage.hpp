#pragma once

#include <cstdint>

namespace ddtool {

/// What this process has used so far, all threads together.
struct ProcessUsage {
    double cpu_s = 0.0;
    std::int64_t peak_memory_bytes = 0;  ///< largest resident set
};

ProcessUsage process_usage();

}  // namespace ddtool
