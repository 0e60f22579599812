#include "ddtool/robot/scan_truth.hpp"

#include <algorithm>

namespace ddtool {

void ScanTruth::add(std::int64_t stamp_ns, const Eigen::Matrix3d& fisher_information) {
    scans_.emplace_back(stamp_ns, fisher_information);
    if (scans_.size() > kept) {
        scans_.pop_front();
    }
}

std::optional<Eigen::Matrix3d> ScanTruth::fisher_information(std::int64_t stamp_ns) const {
    const auto found =
        std::find_if(scans_.rbegin(), scans_.rend(), [&](const auto& scan) { return scan.first == stamp_ns; });
    return found == scans_.rend() ? std::nullopt : std::optional(found->second);
}

}  // namespace ddtool
