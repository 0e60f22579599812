#include "logs/stream/topic_readings.hpp"

#include <optional>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/messages/message_decoder.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/log_container.hpp"
#include "logs/stream/pose_reader.hpp"

namespace ddtool {
namespace {

bool fits_name(const std::string& wanted, const std::string& name) { return wanted.empty() || wanted == name; }

UsageError nothing_read(const std::filesystem::path& log, const std::string& topic, const std::string& what) {
    return UsageError(log.string() + ": " + (topic.empty() ? "has no topic" : "'" + topic + "' is no topic") +
                      " with " + what + "; `ddtool info` lists the topics");
}

}  // namespace

Trajectory read_poses(const std::filesystem::path& log, const std::string& topic, const TransformNames& names,
                      LogProblemHandler on_problem, const std::function<void(double)>& on_progress) {
    const auto source = open_messages(find_log(log), std::move(on_problem));
    PoseReader reader;
    Trajectory poses;
    while (const std::optional<McapMessage> message = source->next()) {
        on_progress(source->fraction_read());
        if (message->channel->topic != topic || !has_poses(kind_of(*message->channel))) {
            continue;
        }
        for (const PoseReading& reading : reader.read(*message).value_or(std::vector<PoseReading>{})) {
            if (fits_name(names.frame, reading.frame_id) && fits_name(names.child_frame, reading.child_frame_id)) {
                poses.push_back({reading.stamp_ns, to_pose2(reading.frame_from_child)});
            }
        }
    }
    if (poses.empty()) {
        throw nothing_read(log, topic, "such poses");
    }
    return poses;
}

std::vector<ImuReading> read_imu(const std::filesystem::path& log, const std::string& topic,
                                 LogProblemHandler on_problem, const std::function<void(double)>& on_progress) {
    const auto source = open_messages(find_log(log), std::move(on_problem));
    std::string used = topic;
    std::vector<ImuReading> readings;
    while (const std::optional<McapMessage> message = source->next()) {
        on_progress(source->fraction_read());
        if (!fits_name(used, message->channel->topic) || kind_of(*message->channel) != MessageKind::inertial) {
            continue;
        }
        if (const std::optional<ImuReading> reading = decode_imu(*message)) {
            used = message->channel->topic;
            readings.push_back(*reading);
        }
    }
    if (readings.empty()) {
        throw nothing_read(log, topic, "readings of an inertial sensor");
    }
    return readings;
}

}  // namespace ddtool
