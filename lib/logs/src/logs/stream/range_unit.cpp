#include "logs/stream/range_unit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.hpp"

namespace ddtool {
namespace {

constexpr std::size_t most_judged = 1000;
constexpr std::size_t least_readings = 10;  ///< different ones
/// Lidars that see farther have most of their echoes nearer, too; in centimetres a room of a metre has this size.
constexpr float far_range_m = 100.0F;

}  // namespace

/// Readings that are the same count once, because they may stand for a missing return.
void RangeUnit::add(const LaserScan& scan) {
    if (scans_ >= most_judged) {
        return;
    }
    std::vector<float> readings;
    std::ranges::copy_if(scan.ranges_m, std::back_inserter(readings),
                         [](float range_m) { return std::isfinite(range_m) && range_m > 0.0F; });
    std::ranges::sort(readings);
    readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
    if (readings.size() >= least_readings) {
        ++scans_;
        far_ += readings[readings.size() / 2] > far_range_m ? 1 : 0;
        largest_m_ = std::max(largest_m_, static_cast<double>(readings.back()));
    }
}

std::string RangeUnit::fault() const {
    if (scans_ == 0 || 2 * far_ <= scans_) {
        return "";
    }
    return "in " + std::to_string(far_) + " of " + std::to_string(scans_) + " scans half of the ranges are beyond " +
           fixed_text(far_range_m, 0) + " (up to " + fixed_text(largest_m_, 0) +
           "), as if they were in another unit; expected metres";
}

}  // namespace ddtool
