#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace ddtool {

/// What a simulator knows of its scans and no robot does. A SensorStream writes it beside the frames that it gives out,
/// for those who compare with the truth: the detector `oracle` and the bound `known-map`. The filter does not see it.
/// Used by one thread at a time.
class ScanTruth {
public:
    /// fisher_information: what the scan with that stamp tells of the robot's true pose, about (x, y, theta) in the
    /// robot's frame (sim/fisher_information.hpp).
    void add(std::int64_t stamp_ns, const Eigen::Matrix3d& fisher_information);

    /// Of the scan with that stamp; none where the source had none, or where `kept` scans have come since.
    [[nodiscard]] std::optional<Eigen::Matrix3d> fisher_information(std::int64_t stamp_ns) const;

    /// So many of the latest scans are remembered: who asks, asks about the frame in hand.
    static constexpr std::size_t kept = 64;

private:
    std::deque<std::pair<std::int64_t, Eigen::Matrix3d>> scans_;
};

}  // namespace ddtool
