#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "logs/messages/readings.hpp"
#include "logs/stream/clock_lag.hpp"
#include "logs/stream/interleaved_paths.hpp"
#include "logs/stream/stamp_survey.hpp"
#include "logs/stream/turn_lag.hpp"
#include "logs/stream/way_scale.hpp"

namespace ddtool {

/// What a log holds of one moving frame: an odometry topic, or the transforms between two frames.
class TrackSurvey {
public:
    /// \param connection that the reading came by, where the log has connections
    void add(const PoseReading& reading, std::int64_t recorded_ns, std::uint16_t connection);

    /// Readings with a rotation; the others cannot be used.
    [[nodiscard]] std::size_t usable() const { return usable_; }
    [[nodiscard]] std::size_t without_rotation() const { return without_rotation_; }
    /// Whether a pose is farther from the first one than 2 cm or 0.02 rad.
    [[nodiscard]] bool moves() const { return moves_; }
    /// Of the readings that have a stamp.
    [[nodiscard]] const ClockLag& clock() const { return clock_; }
    [[nodiscard]] const HeadingTrack& heading() const { return heading_; }
    [[nodiscard]] const WayTrack& way() const { return way_; }
    /// The median time between the first thousand readings; 0 if there are fewer than two.
    [[nodiscard]] double usual_interval_s() const;
    /// The paths of several publishers whose readings are interleaved, by their number in InterleavedPaths; empty where
    /// there is one path.
    [[nodiscard]] std::vector<TrackSurvey> paths() const;
    [[nodiscard]] const InterleavedPaths& interleaved() const { return interleaved_; }
    [[nodiscard]] const StampSurvey& stamps() const { return stamps_; }

private:
    void add(const PoseReading& reading, std::int64_t recorded_ns);

    std::size_t usable_ = 0;
    std::size_t without_rotation_ = 0;
    std::optional<Eigen::Isometry3d> first_;
    bool moves_ = false;
    InterleavedPaths interleaved_;
    std::vector<TrackSurvey> paths_;
    ClockLag clock_;
    HeadingTrack heading_;
    WayTrack way_;
    std::optional<std::int64_t> last_ns_;
    std::vector<double> intervals_s_;  ///< the first ones
    StampSurvey stamps_;
};

}  // namespace ddtool
