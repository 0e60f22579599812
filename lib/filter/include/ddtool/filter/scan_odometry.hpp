#pragma once

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Gives the frames of a log without odometry one made of the scans: each is matched to a map of the last few metres,
/// starting where the speed of the scan before leads. It knows nothing of the motion where the scans look alike.
class ScanOdometryStream : public SensorStream {
public:
    /// settings: of the filter that will take the frames. `source` must outlive this.
    ScanOdometryStream(SensorStream& source, const RbpfSettings& settings);

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return source_.fraction_read(); }

private:
    Pose2 match(const SensorFrame& frame, const ScanPoints& points);
    void enter(const ScanPoints& points);

    SensorStream& source_;
    RbpfSettings settings_;
    ScanMatcher matcher_;
    ScanInserter inserter_;
    OccupancyGrid map_;
    OccupancyGrid next_map_;  ///< begun later: takes over while it holds enough, so that old drift is forgotten
    Pose2 pose_;              ///< odom_from_robot at the last scan
    Pose2 motion_;            ///< between the last two scans
    Pose2 entered_;           ///< pose at the last scan in the maps
    double map_length_m_ = 0.0;
    std::int64_t step_ns_ = 0;  ///< between the last two scans
    std::int64_t stamp_ns_ = 0;
    bool started_ = false;
};

}  // namespace ddtool
