#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pose2.hpp"
#include "sensor/sensor_stream.hpp"

namespace ddtool {

/// The beams of one scan that returned, as end points in the robot's frame; computed once, used by every particle.
/// Structure of arrays: element i of each belongs to the same beam. In angular order.
struct ScanPoints {
    Point2 origin_m;                        ///< the laser in the robot's frame
    std::vector<float> x_m, y_m;            ///< end point
    std::vector<float> normal_x, normal_y;  ///< unit normal of the surface seen; (1, 0) where there is none to tell
    /// Weight of a displacement along the surface relative to one across it, in 0..1: 1 where the neighbours form no
    /// line, so that the point counts alike in every direction.
    std::vector<float> along_weight;
    std::vector<std::int32_t> beam;  ///< index of the beam in the scan; neighbours differ by one

    [[nodiscard]] std::size_t size() const { return x_m.size(); }
};

struct ScanPointsSettings {
    double usable_range_m = 40.0;    ///< longer returns are left out: their end points are beams apart
    double normal_radius_m = 0.25;   ///< neighbours that define the surface normal of a point
    double min_along_weight = 0.05;  ///< along_weight of a perfect line
};

ScanPoints scan_points(const SensorFrame& frame, const ScanPointsSettings& settings);

}  // namespace ddtool
