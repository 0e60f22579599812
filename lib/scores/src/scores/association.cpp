#include "scores/association.hpp"

#include <algorithm>

namespace ddtool {
namespace {

double seconds_between(std::int64_t earlier_ns, std::int64_t later_ns) {
    // The subtraction is unsigned, because the difference of two 64-bit stamps may not fit into a signed integer.
    return static_cast<double>(static_cast<std::uint64_t>(later_ns) - static_cast<std::uint64_t>(earlier_ns)) * 1e-9;
}

}  // namespace

StampIndex::StampIndex(const Trajectory& trajectory) {
    positions_by_stamp_.reserve(trajectory.size());
    for (std::size_t position = 0; position < trajectory.size(); ++position) {
        positions_by_stamp_.emplace_back(trajectory[position].stamp_ns, position);
    }
    std::sort(positions_by_stamp_.begin(), positions_by_stamp_.end());
    const auto repeated = std::unique(positions_by_stamp_.begin(), positions_by_stamp_.end(),
                                      [](const auto& a, const auto& b) { return a.first == b.first; });
    positions_by_stamp_.erase(repeated, positions_by_stamp_.end());
}

std::optional<std::size_t> StampIndex::nearest(std::int64_t stamp_ns, double max_time_difference_s) const {
    const auto after =
        std::lower_bound(positions_by_stamp_.begin(), positions_by_stamp_.end(), std::pair(stamp_ns, std::size_t{0}));
    std::optional<std::size_t> position;
    double smallest_s = max_time_difference_s;
    if (after != positions_by_stamp_.begin()) {
        const auto before = after - 1;
        if (const double difference_s = seconds_between(before->first, stamp_ns); difference_s <= smallest_s) {
            smallest_s = difference_s;
            position = before->second;
        }
    }
    if (after != positions_by_stamp_.end()) {
        const double difference_s = seconds_between(stamp_ns, after->first);
        if (position ? difference_s < smallest_s : difference_s <= smallest_s) {
            position = after->second;
        }
    }
    return position;
}

std::vector<PosePair> associate(const Trajectory& estimate, const Trajectory& reference, double max_time_difference_s) {
    const bool reference_is_longer = reference.size() >= estimate.size();
    const Trajectory& longer = reference_is_longer ? reference : estimate;
    const Trajectory& shorter = reference_is_longer ? estimate : reference;
    const StampIndex index(longer);
    std::vector<PosePair> pairs;
    for (const StampedPose& pose : shorter) {
        if (const auto position = index.nearest(pose.stamp_ns, max_time_difference_s)) {
            const StampedPose& partner = longer[*position];
            pairs.push_back(reference_is_longer ? PosePair{pose.stamp_ns, pose.pose, partner.pose}
                                                : PosePair{partner.stamp_ns, partner.pose, pose.pose});
        }
    }
    return pairs;
}

}  // namespace ddtool
