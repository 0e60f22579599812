#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "ddtool/logs/log_stream.hpp"
#include "logs/stream/pose_reader.hpp"
#include "logs/stream/pose_track.hpp"

namespace ddtool {

/// The poses that the robot itself publishes as its odometry. Those that the filter gets may differ from them: jumps
/// are taken out, and the turns may be those of a gyro. But the transform map -> odom that a robot gets has to fit what
/// the robot publishes.
class RawOdometry {
public:
    void add(const McapMessage& message);
    /// odom_from_robot at the stamp, or the nearest that there is; empty if the log has no odometry.
    [[nodiscard]] std::optional<Pose2> at(std::int64_t stamp_ns, const LogSummary& used);

private:
    struct Key {
        std::string topic;
        std::string frame;
        std::string child;

        auto operator<=>(const Key&) const = default;
    };

    const PoseTrack* track_of(const LogSummary& used);

    std::map<std::string, PoseReader> readers_;  ///< by topic
    std::map<Key, PoseTrack> tracks_;
    bool is_chosen_ = false;  ///< only the track that is used is left
};

}  // namespace ddtool
