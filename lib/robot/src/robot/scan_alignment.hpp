#pragma once

#include <vector>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// How one scan lies on another.
struct ScanAlignment {
    Pose2 first_from_second;
    /// The mean distance of the second scan's points from the lines through the first scan's, where a distance above
    /// 0.2 m counts as 0.2 m; also in metres.
    double residual_m = 0.2;
    double matched_share = 0.0;  ///< of the second scan's points, those with less than 0.2 m
};

/// Some of the end points of a scan, at most 180, in the robot's frame at the stamp, in the order of their beams.
/// \param sweep SensorFrame::sweep, or another
std::vector<Point2> alignment_points(const SensorFrame& frame, const std::vector<Pose2>& sweep);

/// Lays a scan on another that was taken nearby (point to line, Chen and Medioni, "Object modelling by registration of
/// multiple range images", 1992). Points without neighbours that form a line with them are not used.
/// \param first_m, second_m end points in the order of their beams, in metres, each in its own frame
/// \param guess first_from_second, to some centimetres and degrees; the result is also held by it, weakly
ScanAlignment align_scans(const std::vector<Point2>& first_m, const std::vector<Point2>& second_m, const Pose2& guess);

}  // namespace ddtool
