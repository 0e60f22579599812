#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Joins the scans of several lidars to frames that show all around the robot: each scan of the first lidar is a frame,
/// and the latest scan of every other lidar is joined to it. Between their stamps the robot moves by up to one turn of
/// a lidar, for which its odometry is accurate to millimetres.
///
/// Where the first lidar is silent for a second, the next one takes its part until it is back. A single lidar's frames
/// are passed on as they are.
class JoinedScans : public SensorStream {
public:
    /// An older scan is not joined. The slowest lidars turn five times a second.
    static constexpr double oldest_s = 0.25;
    static constexpr double silent_s = 1.0;

    /// `source` must outlive the stream.
    explicit JoinedScans(SensorStream& source) : source_(source) {}

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return source_.fraction_read(); }
    void tell_truth(const std::shared_ptr<ScanTruth>& truth) override { source_.tell_truth(truth); }

private:
    bool leads(const SensorFrame& frame);

    SensorStream& source_;
    std::size_t leader_ = 0;  ///< the lidar whose scans are frames now
    /// What the odometry says of the motion since the last frame, the frames of other lidars included.
    OdometryStep step_ = OdometryStep::measured;
    std::optional<std::int64_t> led_ns_;         ///< the stamp of its latest scan; before the first, that of any scan
    std::map<std::size_t, SensorFrame> latest_;  ///< of each lidar
};

}  // namespace ddtool
