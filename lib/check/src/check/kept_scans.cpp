#include "check/kept_scans.hpp"

#include <cstdlib>

namespace ddtool::check {
namespace {

constexpr std::int64_t longest_wait_ns = 1'000'000'000;

}  // namespace

void KeptScans::offer(const SensorFrame& frame, bool updated) {
    const std::size_t index = seen_++;
    if (!updated && offered_ns_ && std::abs(frame.scan.stamp_ns - *offered_ns_) < longest_wait_ns) {
        return;
    }
    offered_ns_ = frame.scan.stamp_ns;
    if (offered_++ % every_ != 0) {
        return;
    }
    if (scans_.size() == most) {
        for (std::size_t row = 1; 2 * row < most; ++row) {
            scans_[row] = std::move(scans_[2 * row]);
        }
        scans_.erase(scans_.begin() + most / 2, scans_.end());
        every_ *= 2;
    }
    scans_.push_back({.index = index, .odom_from_robot = frame.odom_from_robot, .sight = Sight(frame)});
}

}  // namespace ddtool::check
