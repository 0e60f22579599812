#include "logs/stream/scan_rate.hpp"
#include "base/median.hpp"
#include "robot/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr std::size_t most_periods = 1000;
constexpr std::size_t most_lidars = 64;  // because in a damaged log every scan may be in another frame

}  // namespace

void ScanRate::add(const LaserScan& scan, const std::string& frame_id) {
    if (views_rad_.size() >= most_periods || scan.ranges_m.size() < 2 || !std::isfinite(scan.angle_increment_rad)) {
        return;
    }
    const double increment_rad = std::abs(scan.angle_increment_rad);
    angle_increments_rad_.push_back(increment_rad);
    views_rad_.push_back(increment_rad * static_cast<double>(scan.ranges_m.size() - 1));
    time_increments_s_.push_back(std::isfinite(scan.time_increment_s) ? scan.time_increment_s : 0.0);
    if (const auto last = last_ns_.find(frame_id); last != last_ns_.end()) {
        const double period_s = seconds_between(last->second, scan.stamp_ns);
        if (period_s > 0.0) {
            periods_s_.push_back(period_s);
        }
        last->second = scan.stamp_ns;
    } else if (last_ns_.size() < most_lidars) {
        last_ns_[frame_id] = scan.stamp_ns;
    }
}

double ScanRate::period_s() const { return upper_median(periods_s_); }

double ScanRate::time_increment_s() const { return upper_median(time_increments_s_); }

double ScanRate::view_rad() const { return upper_median(views_rad_); }

double ScanRate::angle_increment_rad() const { return upper_median(angle_increments_rad_); }

}  // namespace ddtool
