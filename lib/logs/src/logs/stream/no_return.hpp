#pragma once

#include <optional>
#include <vector>

namespace ddtool {

/// The reading by which a lidar says "nothing came back", found from the readings of some of its scans; none if there
/// is no such value. Real echoes far away are rare and spread over many values, a code repeats exactly: the most
/// frequent value of the top decimetre is a code when it was read at least ten times and more often than all other
/// values of the metre below the largest together. Takes the readings by value, since it sorts them.
std::optional<float> find_no_return_code(std::vector<float> ranges_m);

}  // namespace ddtool
