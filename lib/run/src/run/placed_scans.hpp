#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// The frames of a stream for a filter that is told where the robot is. A pose told before the first frame is where the
/// robot starts in the map. Of one told later the odometry makes a step to it, in which the filter's particles follow
/// and then match the scan; so the robot may be told its place after it was carried.
class PlacedScans : public SensorStream {
public:
    /// \param told returns map_from_robot, once, if it has been told
    /// All that is given must outlive this object.
    PlacedScans(SensorStream& scans, const ParticleFilter& filter, std::function<std::optional<Pose2>()> told)
        : scans_(scans), filter_(filter), told_(std::move(told)) {}

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return scans_.fraction_read(); }
    void tell_truth(const std::shared_ptr<ScanTruth>& truth) override { scans_.tell_truth(truth); }

private:
    void place(SensorFrame& frame) const;

    SensorStream& scans_;
    const ParticleFilter& filter_;
    std::function<std::optional<Pose2>()> told_;
    Pose2 placed_from_odom_;
    std::optional<Pose2> before_;  ///< odom_from_robot of the last frame, as it was given on
};

}  // namespace ddtool
