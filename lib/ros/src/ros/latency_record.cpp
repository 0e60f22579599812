#include "ros/latency_record.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr double shortest_s = 1e-5;
constexpr double step_ratio = 1.1;

}  // namespace

void LatencyRecord::add(double seconds) {
    const double step = std::ceil(std::log(std::max(seconds, shortest_s) / shortest_s) / std::log(step_ratio));
    ++counts_[std::min(static_cast<std::size_t>(step), steps - 1)];
    ++count_;
}

double LatencyRecord::quantile_s(double share) const {
    std::size_t seen = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        seen += counts_[step];
        if (seen > 0 && static_cast<double>(seen) >= share * static_cast<double>(count_)) {
            return shortest_s * std::pow(step_ratio, static_cast<double>(step));
        }
    }
    return 0.0;
}

}  // namespace ddtool
