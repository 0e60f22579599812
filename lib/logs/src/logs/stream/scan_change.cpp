#include "logs/stream/scan_change.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr float other_range_m = 0.15F;
constexpr std::size_t least_changed = 3;

}  // namespace

bool is_another_view(const std::vector<float>& before_m, const std::vector<float>& after_m) {
    std::size_t compared = 0;
    std::size_t changed = 0;
    for (std::size_t beam = 0; beam < before_m.size() && before_m.size() == after_m.size(); ++beam) {
        if (std::isfinite(before_m[beam]) && std::isfinite(after_m[beam])) {
            ++compared;
            changed += std::abs(before_m[beam] - after_m[beam]) > other_range_m ? 1 : 0;
        }
    }
    return compared > 0 && 2 * changed >= compared;
}

void ScanChange::add(const LaserScan& scan) {
    if (moves() || scan.ranges_m.empty()) {
        return;
    }
    if (scan.ranges_m.size() != first_m_.size()) {
        first_m_ = scan.ranges_m;
        return;
    }
    changed_ += is_another_view(first_m_, scan.ranges_m) ? 1 : 0;
}

bool ScanChange::moves() const { return changed_ >= least_changed; }

}  // namespace ddtool
