#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "logs/messages/readings.hpp"
#include "logs/stream/clock_lag.hpp"
#include "logs/stream/stamp_survey.hpp"

namespace ddtool {

/// What a log holds of one moving frame: an odometry topic, or the transforms between two frames.
class TrackSurvey {
public:
    void add(const PoseReading& reading, std::int64_t recorded_ns);

    /// Readings with a rotation; the others cannot be used.
    [[nodiscard]] std::size_t usable() const { return usable_; }
    [[nodiscard]] std::size_t without_rotation() const { return without_rotation_; }
    /// Whether a pose is farther from the first one than 2 cm or 0.02 rad.
    [[nodiscard]] bool moves() const { return moves_; }
    /// Of the readings that have a stamp.
    [[nodiscard]] const ClockLag& clock() const { return clock_; }
    [[nodiscard]] const StampSurvey& stamps() const { return stamps_; }

private:
    std::size_t usable_ = 0;
    std::size_t without_rotation_ = 0;
    std::optional<Eigen::Isometry3d> first_;
    bool moves_ = false;
    ClockLag clock_;
    StampSurvey stamps_;
};

}  // namespace ddtool
