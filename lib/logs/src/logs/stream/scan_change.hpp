#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// Whether at least half of the beams that have a range in both scans differ by more than 15 cm; false where the scans
/// have not the same number of beams.
bool is_another_view(const std::vector<float>& before_m, const std::vector<float>& after_m);

/// Tells whether the lidar moved in a log: in several scans, at least half of the beams read another range than in the
/// first scan. People who walk past a robot that stands change fewer.
class ScanChange {
public:
    /// \param scan ranges as logged
    void add(const LaserScan& scan);
    [[nodiscard]] bool moves() const;

private:
    std::vector<float> first_m_;
    std::size_t changed_ = 0;  ///< scans
};

}  // namespace ddtool
