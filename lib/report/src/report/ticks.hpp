#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ddtool::report {

/// The marks of an axis, 1, 2 or 5 times a power of ten apart.
struct Ticks {
    std::vector<double> places;  ///< rising, all within the range
    int decimals = 0;            ///< digits after the point that are needed to tell the marks apart
};

/// About `wanted` ticks (from half to twice as many). Requires low < high.
Ticks nice_ticks(double low, double high, std::size_t wanted);

/// The text of a mark with that many decimals. Numbers of seven digits and more are written as powers of ten.
std::string tick_text(double place, int decimals);

}  // namespace ddtool::report
