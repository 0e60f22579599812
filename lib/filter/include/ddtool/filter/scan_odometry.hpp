#pragma once

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Adds an odometry made from the scans to the frames of a log that has none. Each scan is matched to a map of the last
/// few metres, starting from the pose that the latest speed predicts. Where successive scans look alike, for example
/// along a bare corridor, it cannot measure the motion.
class ScanOdometryStream : public SensorStream {
public:
    /// settings: those of the filter that will process the frames. `source` must outlive this object.
    ScanOdometryStream(SensorStream& source, const RbpfSettings& settings);

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return source_.fraction_read(); }

private:
    void place(SensorFrame& frame) const;
    Pose2 match(const SensorFrame& frame, const ScanPoints& points);
    void enter(const ScanPoints& points);

    SensorStream& source_;
    RbpfSettings settings_;
    ScanMatcher matcher_;
    ScanInserter inserter_;
    OccupancyGrid map_;
    OccupancyGrid next_map_;  ///< started later; replaces map_ after a few metres, so that old drift is forgotten
    Pose2 pose_;              ///< odom_from_robot at the last scan
    Pose2 motion_;            ///< motion between the last two scans
    Pose2 entered_;           ///< odom_from_robot at the last scan that was entered into the maps
    double map_length_m_ = 0.0;
    std::int64_t step_ns_ = 0;  ///< time between the last two scans
    std::int64_t stamp_ns_ = 0;
    bool started_ = false;
};

}  // namespace ddtool
