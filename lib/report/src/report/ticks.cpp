#include "report/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ddtool::report {
namespace {

/// The smallest number of the form 1, 2, 5 or 10 times a power of ten that is not below the distance.
double nice_distance(double distance) {
    const double power = std::pow(10.0, std::floor(std::log10(distance)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= distance * (1.0 - 1e-9)) {
            return digit * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

Ticks nice_ticks(double low, double high, std::size_t wanted) {
    const double distance = nice_distance((high - low) / static_cast<double>(wanted));
    Ticks ticks;
    ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(distance) + 1e-9)));
    const double tolerance = 1e-9;
    const double first = std::ceil(low / distance - tolerance);
    const double last = std::floor(high / distance + tolerance);
    const auto count = static_cast<std::size_t>(std::max(0.0, last - first + 1.0));
    for (std::size_t index = 0; index < count; ++index) {
        const double multiple = first + static_cast<double>(index);
        ticks.places.push_back(multiple == 0.0 ? 0.0 : multiple * distance);  // avoids the label "-0"
    }
    return ticks;
}

std::string tick_text(double place, int decimals) {
    std::array<char, 64> text{};
    if (std::abs(place) >= 1e6 || decimals > 6) {
        std::snprintf(text.data(), text.size(), "%.3g", place);
    } else {
        std::snprintf(text.data(), text.size(), "%.*f", decimals, place);
    }
    return text.data();
}

}  // namespace ddtool::report
