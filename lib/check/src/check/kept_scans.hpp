#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/sight.hpp"

namespace ddtool::check {

/// One scan of a run that was kept for the self-check.
struct KeptScan {
    std::size_t index = 0;  ///< its number among all scans of the run
    Pose2 odom_from_robot;
    Sight sight;
};

/// Scans from the whole run, however long it is, in bounded memory: as the run becomes longer, only every second scan
/// is kept, then every fourth, and so on. Those that updated the filter are offered, and others a second apart, so that
/// a robot whose odometry stands still while it drives is watched, too.
class KeptScans {
public:
    static constexpr std::size_t most = 768;

    void offer(const SensorFrame& frame, bool updated);

    [[nodiscard]] const std::vector<KeptScan>& scans() const { return scans_; }

private:
    std::vector<KeptScan> scans_;
    std::size_t seen_ = 0;
    std::size_t offered_ = 0;
    std::size_t every_ = 1;
    std::optional<std::int64_t> offered_ns_;
};

}  // namespace ddtool::check
