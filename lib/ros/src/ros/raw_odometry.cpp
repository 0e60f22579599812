#include "ros/raw_odometry.hpp"

#include "logs/messages/message_decoder.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

constexpr std::size_t most_tracks = 256;

}  // namespace

void RawOdometry::add(const McapMessage& message) {
    if (!has_poses(kind_of(*message.channel))) {
        return;
    }
    const std::string& topic = message.channel->topic;
    const auto readings = readers_[topic].read(message);
    if (!readings) {
        return;
    }
    for (const PoseReading& reading : *readings) {
        const Key key{topic, reading.frame_id, reading.child_frame_id};
        const bool is_kept = tracks_.contains(key) || (!is_chosen_ && tracks_.size() < most_tracks);
        if (is_kept && reading.has_rotation) {
            const std::int64_t stamp_ns = reading.has_stamp ? reading.stamp_ns : message.log_time_ns;
            tracks_[key].add({stamp_ns, to_pose2(reading.frame_from_child)});
        }
    }
}

const PoseTrack* RawOdometry::track_of(const LogSummary& used) {
    const Key key{used.odom_topic, used.odom_frame, used.robot_frame};
    if (!is_chosen_) {
        std::erase_if(tracks_, [&](const auto& track) { return track.first != key; });
        is_chosen_ = true;
    }
    return tracks_.empty() ? nullptr : &tracks_.begin()->second;
}

std::optional<Pose2> RawOdometry::at(std::int64_t stamp_ns, const LogSummary& used) {
    const PoseTrack* const track = used.odom_topic.empty() ? nullptr : track_of(used);
    if (track == nullptr) {
        return std::nullopt;
    }
    if (const std::optional<Pose2> pose = track->extended_at(stamp_ns)) {
        return pose;
    }
    const std::optional<StampedPose> nearest = track->nearest(stamp_ns);
    return nearest ? std::optional(nearest->pose) : std::nullopt;
}

}  // namespace ddtool
