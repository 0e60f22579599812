#pragma once

#include <optional>

#include "logs/log_stream.hpp"
#include "slam/scan_odometry.hpp"

namespace ddtool {

/// The scans with what is known of the robot's motion: the log's own odometry, or one made of the scans.
class DrivenScans {
public:
    /// settings: of the filter that will take the frames. `log` must outlive this.
    DrivenScans(LogStream& log, const RbpfSettings& settings) : log_(log) {
        if (!log.summary().has_odometry) {
            from_scans_.emplace(log, settings);
        }
    }
    [[nodiscard]] SensorStream& frames() { return from_scans_ ? static_cast<SensorStream&>(*from_scans_) : log_; }

private:
    LogStream& log_;
    std::optional<ScanOdometryStream> from_scans_;
};

}  // namespace ddtool
