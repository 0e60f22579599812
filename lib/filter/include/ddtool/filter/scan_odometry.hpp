#pragma once

#include <cstdint>
#include <deque>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Completes the odometry of a log by what the scans say: where a frame's odom_step is not measured, its scan is
/// matched to a map of the last few metres, starting from the guess, or where there is none from the pose that the
/// latest speed predicts. The measured steps are joined to these. Frames whose steps are all measured keep their
/// odometry, to the last bit, and cost nothing but a copy of a scan every few decimetres. Where successive scans look
/// alike, for example along a bare corridor, the scans cannot measure the motion.
class ScanOdometryStream : public SensorStream {
public:
    /// settings: those of the filter that will process the frames. `source` must outlive this object.
    ScanOdometryStream(SensorStream& source, const RbpfSettings& settings);

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return source_.fraction_read(); }

private:
    struct Seen {
        SensorFrame frame;
        Pose2 pose;
    };

    void place(SensorFrame& frame, const Pose2& logged) const;
    [[nodiscard]] Pose2 match(const SensorFrame& frame, const Pose2& step);
    void remember(const SensorFrame& frame);
    void enter_remembered();

    SensorStream& source_;
    RbpfSettings settings_;
    ScanMatcher matcher_;
    ScanInserter inserter_;
    OccupancyGrid map_;
    OccupancyGrid next_map_;  ///< started later; replaces map_ after a few metres, so that old drift is forgotten
    std::deque<Seen> seen_;   ///< the latest scans that are to be entered into the maps before a scan is matched
    Pose2 pose_;              ///< odom_from_robot at the last scan
    Pose2 logged_;            ///< the same as the source gives it
    Pose2 motion_;            ///< motion between the last two scans
    Pose2 remembered_;        ///< odom_from_robot at the last scan that went into seen_
    Pose2 entered_;           ///< odom_from_robot at the last scan that was entered into the maps
    double map_length_m_ = 0.0;
    std::int64_t step_ns_ = 0;  ///< time between the last two scans
    std::int64_t stamp_ns_ = 0;
    bool started_ = false;
    bool matched_ = false;  ///< whether pose_ may differ from logged_
};

}  // namespace ddtool
