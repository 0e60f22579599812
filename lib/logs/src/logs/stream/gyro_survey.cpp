#include "logs/stream/gyro_survey.hpp"

#include <cmath>

namespace ddtool {
namespace {

constexpr double gravity_m_per_s2 = 9.81;
/// Cheap accelerometers err by some tenths; a robot that drives does not change the mean.
constexpr double gravity_tolerance = 0.15;

}  // namespace

void GyroSurvey::add(const ImuReading& reading, std::int64_t recorded_ns) {
    if (readings_ == 0) {
        frame_id_ = reading.frame_id;
    }
    ++readings_;
    clock_.add(reading.stamp_ns, recorded_ns);
    acceleration_sum_ += reading.acceleration_m_per_s2;
}

std::optional<Eigen::Vector3d> GyroSurvey::upwards() const {
    const Eigen::Vector3d mean = acceleration_sum_ / static_cast<double>(readings_);
    const bool is_gravity = std::abs(mean.norm() / gravity_m_per_s2 - 1.0) < gravity_tolerance;
    return is_gravity ? std::optional<Eigen::Vector3d>(mean.normalized()) : std::nullopt;
}

}  // namespace ddtool
