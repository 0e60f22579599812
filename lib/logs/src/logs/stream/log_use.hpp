#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "robot/stamps.hpp"

namespace ddtool {

/// A description of the frames of a log: everything that a run over the log would get.
struct LogUse {
    LogSummary summary;
    std::size_t lidars = 0;  ///< whose scans are used
    std::size_t fewest_beams = 0;
    std::size_t most_beams = 0;
    double field_of_view_rad = 0.0;        ///< of the last scan, from its first beam to its last
    double range_max_m = 0.0;              ///< of the last scan
    std::vector<Pose2> robot_from_lasers;  ///< all that differ, in the order of the scans; at most 16
    std::int64_t first_ns = 0;             ///< stamps of the first and the last scan
    std::int64_t last_ns = 0;
    double longest_gap_s = 0.0;         ///< between the stamps of two scans of a lidar
    std::size_t stamps_back = 0;        ///< scans whose stamp is earlier than that of the lidar's previous scan
    double most_back_s = 0.0;           ///< by how much, at most
    std::size_t beams = 0;              ///< of all scans
    std::size_t returns = 0;            ///< beams with a range
    double odometry_m = 0.0;            ///< distance driven by odometry, added up from scan to scan of the first lidar
    std::size_t with_ground_truth = 0;  ///< scans with a true pose

    /// From the first stamp to the last.
    [[nodiscard]] double duration_s() const { return seconds_between(first_ns, last_ns); }
};

/// The number of beams with a range.
std::size_t returns_of(const LaserScan& scan);

/// Why no map can be made of the frames that a log gave, of which `returns` beams have a range; empty if one can.
std::string why_unusable(const LogSummary& summary, std::size_t returns);

/// Reads the log to its end.
/// \param on_progress is called with the share read, 0..1
LogUse use_of(LogStream& log, const std::function<void(double)>& on_progress);

}  // namespace ddtool
