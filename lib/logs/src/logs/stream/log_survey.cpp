#include "logs/stream/log_survey.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "logs/stream/cloud_scan.hpp"
#include "logs/stream/pose_reader.hpp"
#include "logs/stream/scan_angles.hpp"
#include "logs/stream/topic_names.hpp"

namespace ddtool {
namespace {

constexpr double usual_extent_ns = 10e9;
constexpr double soon_extent_ns = 3e9;
/// What is looked through of a log that can be read only once is kept in memory.
constexpr std::size_t most_cloud_bytes = std::size_t{256} << 20;

class Surveyor {
public:
    explicit Surveyor(const LogOptions& options) : options_(options) {}

    void take(const McapMessage& message) {
        first_ns_ = first_ns_.value_or(message.log_time_ns);
        latest_ns_ = message.log_time_ns;
        extent_ns_ = static_cast<double>(latest_ns_) - static_cast<double>(*first_ns_);
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
        if (kind == MessageKind::scan || kind == MessageKind::cloud) {
            first_scan_ns_ = first_scan_ns_.value_or(message.log_time_ns);
        }
        if (kind == MessageKind::scan) {
            note_scan(message, topic);
        } else if (kind == MessageKind::cloud) {
            note_cloud(message, topic);
        } else if (kind == MessageKind::inertial) {
            note_rates(message, topic);
        } else if (has_poses(kind)) {
            note_poses(message, topic);
        }
    }

    [[nodiscard]] bool complete(SurveyExtent extent) const {
        const bool has_scans = has_kind(MessageKind::scan) || has_kind(MessageKind::cloud);
        const bool is_long = extent == SurveyExtent::soon
                                 ? has_lasted_soon()
                                 : extent_ns_ > usual_extent_ns || cloud_bytes_ > most_cloud_bytes;
        return is_long && has_scans && has(options_.scan_topic) && has(options_.cloud_topic) &&
               has(options_.odom_topic) && has(options_.ground_truth_topic) && has(options_.imu_topic);
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
    /// Whether scans have come for as long as SurveyExtent::soon asks for.
    [[nodiscard]] bool has_lasted_soon() const {
        const double scans_ns = first_scan_ns_ ? static_cast<double>(latest_ns_ - *first_scan_ns_) : 0.0;
        const bool has_motion =
            has_kind(MessageKind::odometry) || has_kind(MessageKind::velocity) || has_kind(MessageKind::transforms);
        return scans_ns > (has_motion ? soon_extent_ns : usual_extent_ns);
    }
    /// Whether the topics that an option names are all there.
    [[nodiscard]] bool has(const std::string& option) const {
        return std::ranges::all_of(topics_named(option),
                                   [&](const std::string& topic) { return topics_.contains(topic); });
    }
    [[nodiscard]] bool has_kind(MessageKind kind) const {
        return std::any_of(topics_.begin(), topics_.end(),
                           [&](const auto& entry) { return entry.second.kind == kind; });
    }
    void note_scan(const McapMessage& message, TopicSurvey& topic) const {
        std::optional<ScanReading> reading =
            decode_scan(message, options_.strongest_echo ? Echo::strongest : Echo::first);
        ++topic.scans;
        if (!reading) {
            topic.first_fault = topic.first_fault.empty() ? fault_of(message) : topic.first_fault;
            return;
        }
        ++topic.scans_read;
        topic.scans_in_degrees += read_angles(reading->scan) == ScanAngles::degrees ? 1 : 0;
        topic.scans_with_ranges += has_range(reading->scan) ? 1 : 0;
        topic.unit.add(reading->scan);
        topic.piles.add(reading->scan);
        topic.change.add(reading->scan);
        topic.rate.add(reading->scan, reading->frame_id);
        topic.stamps.add(reading->scan.stamp_ns, reading->has_stamp, message.log_time_ns);
        if (reading->has_stamp) {
            topic.clock.add(reading->scan.stamp_ns, message.log_time_ns);
        }
        note_frame(reading->frame_id, topic);
        if (reading->frame_id == topic.scan_frames.front()) {
            topic.turns.add(reading->scan);
            topic.way.add(reading->scan);
        }
    }
    static void note_frame(const std::string& frame_id, TopicSurvey& topic) {
        std::vector<std::string>& frames = topic.scan_frames;
        if (frames.size() < TopicSurvey::max_frames && std::ranges::count(frames, frame_id) == 0) {
            frames.push_back(frame_id);
        }
    }
    static void note_rates(const McapMessage& message, TopicSurvey& topic) {
        if (const std::optional<ImuReading> reading = decode_imu(message)) {
            topic.gyro.add(*reading, message.log_time_ns);
        }
    }
    /// Clouds are large, so that they are decoded only where they may be used.
    void note_cloud(const McapMessage& message, TopicSurvey& topic) {
        if (has_kind(MessageKind::scan) && options_.cloud_topic.empty()) {
            return;
        }
        cloud_bytes_ += message.data.size();
        ++topic.scans;
        const std::optional<CloudReading> reading = decode_cloud(message);
        if (!reading || !reading->fault.empty()) {
            topic.first_fault = !topic.first_fault.empty() ? topic.first_fault
                                : reading                  ? "a cloud " + reading->fault
                                                           : fault_of(message);
            return;
        }
        ++topic.scans_read;
        topic.scans_with_ranges += reading->points_m.empty() ? 0 : 1;
        topic.stamps.add(reading->stamp_ns, reading->has_stamp, message.log_time_ns);
        constexpr std::size_t beams = 180;
        if (!topic.change.moves()) {
            topic.change.add(cloud_scan(*reading, Eigen::Isometry3d::Identity(), band_around_unknown, beams));
        }
        if (reading->has_stamp) {
            topic.clock.add(reading->stamp_ns, message.log_time_ns);
        }
        note_frame(reading->frame_id, topic);
    }
    void note_poses(const McapMessage& message, TopicSurvey& topic) {
        for (const PoseReading& reading : readers_[topic.topic].read(message).value_or(std::vector<PoseReading>{})) {
            const FramePair frames{reading.frame_id, reading.child_frame_id};
            if (topic.kind != MessageKind::transforms) {
                // One track for the topic, whose messages may name the frames differently.
                (topic.tracks.empty() ? topic.tracks[frames] : topic.tracks.begin()->second)
                    .add(reading, message.log_time_ns, message.channel->id);
                continue;
            }
            if (topic.tracks.size() < TopicSurvey::max_frames || topic.tracks.contains(frames)) {
                topic.tracks[frames].add(reading, message.log_time_ns, message.channel->id);
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
    std::optional<std::int64_t> first_scan_ns_;
    std::int64_t latest_ns_ = 0;
    double extent_ns_ = 0.0;
    std::map<std::string, TopicSurvey> topics_;
    std::map<std::string, PoseReader> readers_;  ///< by topic
    std::map<std::string, TransformTree> transforms_;
    bool has_information_ = false;
    std::size_t cloud_bytes_ = 0;
};

}  // namespace

LogSurvey survey_log(MessageSource& source, SurveyExtent extent, const LogOptions& options) {
    Surveyor surveyor(options);
    bool ended = false;
    while (!ended && (extent == SurveyExtent::whole || !surveyor.complete(extent))) {
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
