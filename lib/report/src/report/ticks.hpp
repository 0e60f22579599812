#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ddtool::plot {

/// Marks of an axis: 1, 2 or 5 times a power of ten apart.
struct Ticks {
    std::vector<double> places;  ///< rising, all within the range
    int decimals = 0;            ///< that tell them apart
};

/// About `wanted` ticks (from half to twice as many) for low < high.
Ticks nice_ticks(double low, double high, std::size_t wanted);

/// The place with that many decimals; numbers of seven digits and more as powers of ten.
std::string tick_text(double place, int decimals);

}  // namespace ddtool::plot
