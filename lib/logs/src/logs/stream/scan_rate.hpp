#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// How often a log has a scan, and how fast its lidar turns by what the scans state. Of each lidar on a topic the first
/// thousand scans are looked at.
class ScanRate {
public:
    /// \param frame_id tells several lidars on one topic apart
    void add(const LaserScan& scan, const std::string& frame_id);

    /// From one scan of a lidar to the next, the median; 0 where unknown.
    [[nodiscard]] double period_s() const;
    /// LaserScan::time_increment_s, the median; 0 where the scans have none.
    [[nodiscard]] double time_increment_s() const;
    /// Of a scan, from its first beam to its last, the median.
    [[nodiscard]] double view_rad() const;
    /// LaserScan::angle_increment_rad without its sign, the median.
    [[nodiscard]] double angle_increment_rad() const;

private:
    std::map<std::string, std::int64_t> last_ns_;  ///< by frame
    std::vector<double> periods_s_;
    std::vector<double> time_increments_s_;
    std::vector<double> views_rad_;
    std::vector<double> angle_increments_rad_;
};

}  // namespace ddtool
