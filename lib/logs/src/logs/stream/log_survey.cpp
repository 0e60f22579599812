#include "logs/stream/log_survey.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "logs/stream/topic_names.hpp"

namespace ddtool {
namespace {

constexpr double usual_extent_ns = 10e9;

class Surveyor {
public:
    explicit Surveyor(const LogOptions& options) : options_(options) {}

    void take(const McapMessage& message) {
        first_ns_ = first_ns_.value_or(message.log_time_ns);
        extent_ns_ = static_cast<double>(message.log_time_ns) - static_cast<double>(*first_ns_);
        has_information_ = has_information_ || is_information(*message.channel);
        const MessageKind kind = kind_of(*message.channel);
        TopicSurvey& topic = topics_[message.channel->topic];
        if (topic.topic.empty()) {
            topic.topic = message.channel->topic;
            topic.type = message.channel->schema.name;
            topic.kind = kind;
        }
        if (kind != topic.kind) {
            return;  // a topic of two types is what it is first
        }
        if (kind == MessageKind::scan) {
            note_scan(message, topic);
        } else if (kind != MessageKind::other) {
            note_poses(message, topic);
        }
    }

    [[nodiscard]] bool complete() const {
        return extent_ns_ > usual_extent_ns && has_scan() && has(options_.scan_topic) && has(options_.odom_topic) &&
               has(options_.ground_truth_topic);
    }

    LogSurvey result() {
        LogSurvey survey;
        for (auto& [name, topic] : topics_) {
            survey.topics.push_back(std::move(topic));
        }
        survey.has_information = has_information_;
        survey.transforms = std::move(transforms_);
        return survey;
    }

private:
    [[nodiscard]] bool has(const std::string& topic) const { return topic.empty() || topics_.contains(topic); }
    [[nodiscard]] bool has_scan() const {
        return std::any_of(topics_.begin(), topics_.end(),
                           [](const auto& entry) { return entry.second.kind == MessageKind::scan; });
    }
    static void note_scan(const McapMessage& message, TopicSurvey& topic) {
        const std::optional<ScanReading> reading = decode_scan(message);
        ++topic.scans;
        if (!reading) {
            topic.first_fault = topic.first_fault.empty() ? fault_of(message) : topic.first_fault;
            return;
        }
        ++topic.scans_read;
        topic.scans_with_ranges += has_range(reading->scan) ? 1 : 0;
        topic.piles.add(reading->scan);
        topic.change.add(reading->scan);
        topic.stamps.add(reading->scan.stamp_ns, reading->has_stamp, message.log_time_ns);
        if (reading->has_stamp) {
            topic.clock.add(reading->scan.stamp_ns, message.log_time_ns);
        }
        std::vector<std::string>& frames = topic.scan_frames;
        if (frames.size() < TopicSurvey::max_frames && std::ranges::count(frames, reading->frame_id) == 0) {
            frames.push_back(reading->frame_id);
        }
    }
    void note_poses(const McapMessage& message, TopicSurvey& topic) {
        for (const PoseReading& reading : decode_poses(message).value_or(std::vector<PoseReading>{})) {
            const FramePair frames{reading.frame_id, reading.child_frame_id};
            if (topic.kind != MessageKind::transforms) {
                // One track for the topic, whose messages may name the frames differently.
                (topic.tracks.empty() ? topic.tracks[frames] : topic.tracks.begin()->second)
                    .add(reading, message.log_time_ns);
                continue;
            }
            if (topic.tracks.size() < TopicSurvey::max_frames || topic.tracks.contains(frames)) {
                topic.tracks[frames].add(reading, message.log_time_ns);
            }
            transforms_[transform_namespace(topic.topic)].set(reading);
        }
    }

    static bool has_range(const LaserScan& scan) {
        return std::ranges::any_of(scan.ranges_m,
                                   [](float range_m) { return std::isfinite(range_m) && range_m > 0.0F; });
    }

    const LogOptions& options_;
    std::optional<std::int64_t> first_ns_;
    double extent_ns_ = 0.0;
    std::map<std::string, TopicSurvey> topics_;
    std::map<std::string, TransformTree> transforms_;
    bool has_information_ = false;
};

}  // namespace

LogSurvey survey_log(MessageSource& source, SurveyExtent extent, const LogOptions& options) {
    Surveyor surveyor(options);
    bool ended = false;
    while (!ended && (extent == SurveyExtent::whole || !surveyor.complete())) {
        if (const std::optional<McapMessage> message = source.next()) {
            surveyor.take(*message);
        } else {
            ended = true;
        }
    }
    LogSurvey survey = surveyor.result();
    survey.is_whole = ended;
    return survey;
}

}  // namespace ddtool
