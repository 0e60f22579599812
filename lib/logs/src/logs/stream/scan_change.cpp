#include "logs/stream/scan_change.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr float other_range_m = 0.15F;
constexpr std::size_t least_changed = 3;

}  // namespace

void ScanChange::add(const LaserScan& scan) {
    if (moves() || scan.ranges_m.empty()) {
        return;
    }
    if (scan.ranges_m.size() != first_m_.size()) {
        first_m_ = scan.ranges_m;
        return;
    }
    std::size_t compared = 0;
    std::size_t changed = 0;
    for (std::size_t beam = 0; beam < first_m_.size(); ++beam) {
        if (std::isfinite(first_m_[beam]) && std::isfinite(scan.ranges_m[beam])) {
            ++compared;
            changed += std::abs(first_m_[beam] - scan.ranges_m[beam]) > other_range_m ? 1 : 0;
        }
    }
    changed_ += compared > 0 && 2 * changed >= compared ? 1 : 0;
}

bool ScanChange::moves() const { return changed_ >= least_changed; }

}  // namespace ddtool
