#include "logs/stream/log_survey.hpp"

#include <algorithm>
#include <optional>
#include <utility>

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
        const auto [entry, is_new] =
            topics_.try_emplace(message.channel->topic,
                                TopicSurvey{message.channel->topic, message.channel->schema.name, kind, "", "", {}});
        if (is_new) {
            note_frames(message, entry->second);
        }
        if (kind == MessageKind::transforms) {
            note_transforms(message);
        } else if (kind == MessageKind::scan) {
            note_scan(message, entry->second);
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
    static void note_frames(const McapMessage& message, TopicSurvey& topic) {
        if (topic.kind == MessageKind::scan) {
            topic.frame_id = decode_scan(message).value_or(ScanReading{}).frame_id;
        } else if (topic.kind == MessageKind::odometry) {
            const auto poses = decode_poses(message);
            topic.frame_id = poses ? poses->front().frame_id : "";
            topic.child_frame_id = poses ? poses->front().child_frame_id : "";
        }
    }
    static void note_scan(const McapMessage& message, TopicSurvey& topic) {
        if (const std::optional<ScanReading> reading = decode_scan(message)) {
            topic.piles.add(reading->scan);
        }
    }
    void note_transforms(const McapMessage& message) {
        for (const PoseReading& transform : decode_poses(message).value_or(std::vector<PoseReading>{})) {
            transforms_.set(transform);
        }
    }

    const LogOptions& options_;
    std::optional<std::int64_t> first_ns_;
    double extent_ns_ = 0.0;
    std::map<std::string, TopicSurvey> topics_;
    TransformTree transforms_;
    bool has_information_ = false;
};

}  // namespace

LogSurvey survey_log(MessageSource& source, SurveyExtent extent, const LogOptions& options) {
    Surveyor surveyor(options);
    while (extent == SurveyExtent::whole || !surveyor.complete()) {
        const std::optional<McapMessage> message = source.next();
        if (!message) {
            break;
        }
        surveyor.take(*message);
    }
    return surveyor.result();
}

}  // namespace ddtool
