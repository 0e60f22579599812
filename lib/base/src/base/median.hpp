#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ddtool {

/// The middle value, of an even number of values the upper one of the two in the middle; 0 if there are none.
inline double upper_median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace ddtool
