#pragma once

#include <optional>
#include <vector>

namespace ddtool {

/// Finds the value that a lidar reports when a beam has no return, from the readings of some of its scans; nullopt if
/// there is no such value. Real echoes from far away are rare and have many different values, while a code is always
/// exactly the same. The most frequent value of the top decimetre is therefore taken for a code if it was read at least
/// ten times, and more often than all other values together of the metre below the largest reading. The readings are
/// passed by value because they are sorted.
std::optional<float> find_no_return_code(std::vector<float> ranges_m);

}  // namespace ddtool
