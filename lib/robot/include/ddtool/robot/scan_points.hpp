#pragma once

#include <cstdint>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// The end points of a scan, and of those joined to it, in the robot's frame, computed once and used by every particle.
/// Neighbouring beams that end within spacing_m of each other are merged to one point at their mean. The points are
/// stored as one array per coordinate, scan by scan in angular order.
struct ScanPoints {
    Point2 origin_m;                        ///< the laser in the robot's frame, in the middle of the sweep
    std::vector<float> x_m, y_m;            ///< end point
    std::vector<float> normal_x, normal_y;  ///< unit normal of the surface; (1, 0) where it is unknown
    /// How much a displacement along the surface counts, relative to one across it: 0 on a perfect line, and 1 where
    /// the neighbours form no line, so that the point counts equally in every direction.
    std::vector<float> along_weight;
    /// Rises by 1 between neighbours on one surface, by order_jump between neighbours where the range jumps, and by
    /// order_gap or more across beams without return.
    std::vector<std::int32_t> order;
    static constexpr std::int32_t order_jump = 2;
    static constexpr std::int32_t order_gap = 3;
    /// The points of one further lidar (SensorFrame::joined); its order goes on behind a gap.
    struct Joined {
        Point2 origin_m;        ///< the laser in the robot's frame
        std::size_t begin = 0;  ///< its first point; its last is before the first of the next
    };
    std::vector<Joined> joined;  ///< behind the points of the frame's own scan, which may be none

    /// Neighbours within this distance define the surface normal of a point. No setting: over 0.25 m the normals are
    /// smeared across the recesses of a textured corridor, which then comes out long; nearer ones are mostly noise.
    static constexpr double normal_radius_m = 0.18;
    /// Neighbours whose spread across is at most this share of that along form a line up to noise: it says nothing of
    /// where along it the point is. No setting: counting noise as shape makes a bare wall hold the robot along itself,
    /// and range noise of 15 mm over 0.25 m then counts as a tenth of a corner.
    static constexpr double line_flatness = 0.3;

    [[nodiscard]] std::size_t size() const { return x_m.size(); }
};

struct ScanPointsSettings {
    double usable_range_m = 40.0;  ///< longer ranges are not used, because their end points lie too far apart
    double spacing_m = 0.03;       ///< neighbours that are nearer are merged
    bool deskew = true;            ///< place each beam where the laser was when it was measured (SensorFrame::sweep)
};

/// All points are in the robot's frame at the stamp of the scan.
ScanPoints scan_points(const SensorFrame& frame, const ScanPointsSettings& settings);

}  // namespace ddtool
