#pragma once

#include <cstddef>
#include <string>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// Doubts whether the ranges of a log are in metres, by its first thousand scans.
class RangeUnit {
public:
    /// \param scan ranges as logged
    void add(const LaserScan& scan);
    /// "in 990 of 1000 scans half of the readings are beyond 100 m (usually beyond 3214), ..."; empty if all is well.
    [[nodiscard]] std::string fault() const;

private:
    std::size_t scans_ = 0;  ///< with readings
    std::size_t far_ = 0;    ///< of these, with half of the readings beyond what lidars see
    double largest_m_ = 0.0;
};

}  // namespace ddtool
