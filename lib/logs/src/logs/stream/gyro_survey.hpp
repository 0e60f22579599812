#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>

#include "logs/messages/readings.hpp"
#include "logs/stream/clock_lag.hpp"

namespace ddtool {

/// What a log holds of one inertial sensor.
class GyroSurvey {
public:
    void add(const ImuReading& reading, std::int64_t recorded_ns);

    [[nodiscard]] std::size_t readings() const { return readings_; }
    /// Of the first reading.
    [[nodiscard]] const std::string& frame_id() const { return frame_id_; }
    [[nodiscard]] const ClockLag& clock() const { return clock_; }
    /// The direction in the sensor's frame that points upwards, by the mean acceleration. Nullopt if that is not
    /// gravity's, because the sensor does not measure accelerations, or takes gravity off.
    [[nodiscard]] std::optional<Eigen::Vector3d> upwards() const;

private:
    std::size_t readings_ = 0;
    std::string frame_id_;
    ClockLag clock_;
    Eigen::Vector3d acceleration_sum_ = Eigen::Vector3d::Zero();
};

}  // namespace ddtool
