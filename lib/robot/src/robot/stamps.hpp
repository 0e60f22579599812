#pragma once

#include <cstdint>

namespace ddtool {

/// Negative where `to_ns` is the earlier one. The stamps of a damaged log may be as far apart as numbers are, which is
/// why they become fractions before they are subtracted.
inline double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
    return 1e-9 * (static_cast<double>(to_ns) - static_cast<double>(from_ns));
}

}  // namespace ddtool
