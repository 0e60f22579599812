#include "logs/stream/log_inventory.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "logs/containers/line_reader.hpp"
#include "logs/messages/message_decoder.hpp"
#include "logs/stream/log_container.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

/// Limit on the frames that are listed for a topic, because in a damaged log every message may name another one.
constexpr std::size_t max_frames = 64;

using CountedTopics = std::map<std::string, TopicInventory>;

void count(TopicInventory& topic, std::int64_t time_ns) {
    topic.first_ns = topic.messages == 0 ? time_ns : std::min(topic.first_ns, time_ns);
    topic.last_ns = topic.messages == 0 ? time_ns : std::max(topic.last_ns, time_ns);
    ++topic.messages;
}

std::vector<std::string> frames_of(const McapMessage& message, MessageKind kind) {
    std::vector<std::string> frames;
    if (kind == MessageKind::scan) {
        frames.push_back(decode_scan(message).value_or(ScanReading{}).frame_id);
    } else if (kind == MessageKind::velocity) {
        frames.push_back(decode_velocity(message).value_or(VelocityReading{}).frame_id);
    } else if (kind == MessageKind::inertial) {
        frames.push_back(decode_imu(message).value_or(ImuReading{}).frame_id);
    } else if (kind == MessageKind::cloud) {
        frames.push_back(decode_cloud(message).value_or(CloudReading{}).frame_id);
    } else if (has_poses(kind)) {
        for (const PoseReading& pose : decode_poses(message).value_or(std::vector<PoseReading>{})) {
            frames.push_back(pose.frame_id + (pose.child_frame_id.empty() ? "" : " -> " + pose.child_frame_id));
        }
    }
    return frames;
}

/// Notes the frames of a message. Transforms of many frames share a topic, so each message is examined; on other topics
/// the first message is enough.
void note_frames(TopicInventory& topic, const McapMessage& message) {
    const MessageKind kind = kind_of(*message.channel);
    if (topic.messages > 1 && (kind != MessageKind::transforms || topic.frames.size() >= max_frames)) {
        return;
    }
    for (std::string& frame : frames_of(message, kind)) {
        topic.frames.insert(std::move(frame));
    }
    topic.frames.erase("");
}

CountedTopics count_messages(MessageSource& source, const std::function<void(double)>& on_progress) {
    CountedTopics topics;
    while (const std::optional<McapMessage> message = source.next()) {
        TopicInventory& topic = topics[message->channel->topic];
        topic.type = message->channel->schema.name;
        topic.encoding = message->channel->message_encoding;
        count(topic, message->log_time_ns);
        note_frames(topic, *message);
        on_progress(source.fraction_read());
    }
    return topics;
}

/// The ipc time of a line. Every line of a CARMEN log ends with the ipc time, the host and the logger's time.
std::optional<std::int64_t> ipc_time_ns(std::string_view words) {
    std::array<std::string_view, 3> last;
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
        last = {last[1], last[2], word};
    }
    return parse_stamp(last[0]);
}

CountedTopics count_lines(LineReader& lines, const std::function<void(double)>& on_progress) {
    CountedTopics topics;
    while (std::optional<std::string_view> line = lines.next()) {
        const std::string name(next_word(*line));
        const std::optional<std::int64_t> time_ns = ipc_time_ns(*line);
        const bool is_message = !name.empty() && name.front() >= 'A' && name.front() <= 'Z';
        if (is_message && time_ns) {
            count(topics[name], *time_ns);
        }
        on_progress(lines.fraction_read());
    }
    return topics;
}

/// Whether the times of a topic are known. The parameters in a CARMEN log have the time 0.
bool is_timed(const TopicInventory& topic) { return topic.first_ns != 0 || topic.last_ns != 0; }

}  // namespace

double TopicInventory::rate_hz() const {
    const double duration_s = seconds_between(first_ns, last_ns);
    return duration_s > 0.0 ? static_cast<double>(messages - 1) / duration_s : std::numeric_limits<double>::quiet_NaN();
}

std::size_t LogInventory::messages() const {
    std::size_t sum = 0;
    for (const TopicInventory& topic : topics) {
        sum += topic.messages;
    }
    return sum;
}

std::int64_t LogInventory::first_ns() const {
    std::int64_t first_ns = last_ns();
    for (const TopicInventory& topic : topics) {
        first_ns = is_timed(topic) ? std::min(first_ns, topic.first_ns) : first_ns;
    }
    return first_ns;
}

std::int64_t LogInventory::last_ns() const {
    return topics.empty() ? 0 : std::ranges::max(topics, {}, &TopicInventory::last_ns).last_ns;
}

double LogInventory::duration_s() const { return seconds_between(first_ns(), last_ns()); }

LogInventory take_inventory(const std::filesystem::path& path, LogProblemHandler on_problem,
                            const std::function<void(double)>& on_progress) {
    const FoundLog log = find_log(path);
    CountedTopics topics;
    if (log.container == LogContainer::carmen) {
        LineReader lines = open_lines(log, on_problem);
        topics = count_lines(lines, on_progress);
    } else {
        topics = count_messages(*open_messages(log, std::move(on_problem)), on_progress);
    }
    LogInventory inventory{.format = std::string(name_of(log.container)), .topics = {}};
    for (auto& [name, topic] : topics) {
        topic.topic = name;
        inventory.topics.push_back(std::move(topic));
    }
    return inventory;
}

}  // namespace ddtool
