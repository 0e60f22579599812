#include "logs/stream/message_log_stream.hpp"

#include <cmath>
#include <utility>

#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/kept_messages.hpp"
#include "logs/stream/laser_mounting.hpp"

namespace ddtool {
namespace {

double seconds_between(std::int64_t a_ns, std::int64_t b_ns) {
    return std::abs(static_cast<double>(a_ns) - static_cast<double>(b_ns)) * 1e-9;
}

}  // namespace

MessageLogStream::MessageLogStream(const OpenSource& open, Opening opening, std::string format, std::string file,
                                   const LogOptions& options, LogProblemHandler on_problem)
    : LogStream(std::move(on_problem)), file_(std::move(file)) {
    if (opening == Opening::twice) {
        survey(open, options);
    } else {
        survey_once(open, options);
    }
    summary_.format = std::move(format);
    summary_.scan_topic = plan_.scan_topic;
    summary_.odom_topic = plan_.odom_topic;
    summary_.has_odometry = !plan_.odom_topic.empty();
    summary_.ground_truth_topic = plan_.ground_truth_topic;
    summary_.assumptions = plan_.assumptions;
    scan_times_ = StampReader(plan_.scan_stamps);
    odom_times_ = StampReader(plan_.odom_stamps);
    ground_truth_times_ = StampReader(plan_.ground_truth_stamps);
    for (const std::string& fault : plan_.faults) {
        report({fault});
    }
}

void MessageLogStream::survey(const OpenSource& open, const LogOptions& options) {
    const auto survey_source = open([](const LogProblem&) {});  // problems are reported at the second reading
    plan_ = plan_log(survey_log(*survey_source, SurveyExtent::whole, options), options, file_);
    source_ = open([this](const LogProblem& problem) { report(problem); });
}

void MessageLogStream::survey_once(const OpenSource& open, const LogOptions& options) {
    auto source = std::make_unique<KeptMessages>(open([this](const LogProblem& problem) { report(problem); }));
    plan_ = plan_log(survey_log(*source, SurveyExtent::beginning, options), options, file_);
    source->rewind();
    source_ = std::move(source);
}

std::optional<SensorFrame> MessageLogStream::next() {
    while (!ended_ && !first_is_ready()) {
        if (const std::optional<McapMessage> message = source_->next()) {
            take(*message);
        } else {
            ended_ = true;
        }
    }
    return waiting_.empty() ? std::nullopt : std::optional(release_first());
}

void MessageLogStream::take(const McapMessage& message) {
    const std::string& topic = message.channel->topic;
    if (is_information(*message.channel)) {
        take_information(message);
        return;
    }
    const MessageKind kind = kind_of(*message.channel);
    if (kind == MessageKind::other) {
        return;
    }
    if (kind == MessageKind::scan) {
        if (topic == plan_.scan_topic) {
            take_scan(message);
        }
        return;
    }
    if (topic == plan_.odom_topic) {
        take_odometry(message);
    }
    if (topic == plan_.ground_truth_topic) {
        take_ground_truth(message);
    }
}

void MessageLogStream::take_scan(const McapMessage& message) {
    std::optional<ScanReading> reading = decode_scan(message);
    if (!reading) {
        report_message(message, fault_of(message));
        return;
    }
    reading->scan.stamp_ns = scan_times_.time_ns(reading->scan.stamp_ns, reading->has_stamp, message.log_time_ns);
    WaitingScan scan;
    const Eigen::Isometry3d* robot_from_laser = mounting_of(reading->frame_id);
    if (robot_from_laser == nullptr) {
        report_message(message,
                       "a scan in the frame '" + reading->frame_id + "', which no transform places on the robot,");
        return;
    }
    if (const auto fault = place_scan(std::move(*reading), *robot_from_laser, plan_.ranges, scan.frame)) {
        report_message(message, *fault);
        return;
    }
    const std::int64_t stamp_ns = scan.frame.scan.stamp_ns;
    scan.has_odometry = plan_.odom_topic.empty() || odometry_.contains(stamp_ns);
    scan.has_ground_truth = plan_.ground_truth_topic.empty() || ground_truth_.contains(stamp_ns);
    scan.has_information = !plan_.has_information;
    waiting_.push_back(std::move(scan));
}

void MessageLogStream::take_odometry(const McapMessage& message) {
    const auto readings = decode_poses(message);
    if (!readings) {
        report_message(message, fault_of(message));
        return;
    }
    for (const PoseReading& reading : *readings) {
        if (is_odometry(reading) && has_rotation(reading, message)) {
            ++summary_.odometry;
            const std::int64_t stamp_ns =
                stamp_sum(odom_times_.time_ns(reading.stamp_ns, reading.has_stamp, message.log_time_ns),
                          plan_.odom_clock_offset_ns);
            const Pose2 odom_from_robot = resets_.follow({stamp_ns, to_pose2(reading.frame_from_child)});
            if (const auto& jump = resets_.last_jump()) {
                report({file_ + ": the odometry " + plan_.odom_topic + " " + OdometryResets::text(*jump) + " (near " +
                            message.offset_unit + " " + std::to_string(message.file_offset) + ")",
                        message.file_offset});
            }
            odometry_.add({stamp_ns, odom_from_robot});
            for (WaitingScan& scan : waiting_) {
                scan.has_odometry = scan.has_odometry || scan.frame.scan.stamp_ns <= stamp_ns;
            }
        }
    }
}

void MessageLogStream::take_ground_truth(const McapMessage& message) {
    const auto readings = decode_poses(message);
    if (!readings) {
        report_message(message, fault_of(message));
        return;
    }
    for (const PoseReading& reading : *readings) {
        if (!has_rotation(reading, message)) {
            continue;
        }
        ++summary_.ground_truth;
        const std::int64_t stamp_ns =
            ground_truth_times_.time_ns(reading.stamp_ns, reading.has_stamp, message.log_time_ns);
        ground_truth_.add({stamp_ns, to_pose2(reading.frame_from_child)});
        for (WaitingScan& scan : waiting_) {
            scan.has_ground_truth = scan.has_ground_truth || scan.frame.scan.stamp_ns <= stamp_ns;
        }
    }
}

void MessageLogStream::take_information(const McapMessage& message) {
    const std::optional<Eigen::Matrix3d> information = decode_information(message);
    if (!information) {
        report_message(message, fault_of(message));
    }
    for (WaitingScan& scan : waiting_) {
        if (scan.frame.scan.stamp_ns == message.log_time_ns) {
            scan.information = information;
        }
        scan.has_information = scan.has_information || scan.frame.scan.stamp_ns <= message.log_time_ns;
    }
}

bool MessageLogStream::has_rotation(const PoseReading& reading, const McapMessage& message) {
    if (!reading.has_rotation) {
        report_message(message, "a pose whose rotation is 0,0,0,0 or no number");
    }
    return reading.has_rotation;
}

const Eigen::Isometry3d* MessageLogStream::mounting_of(const std::string& frame_id) const {
    if (const auto known = plan_.robot_from_laser.find(frame_id); known != plan_.robot_from_laser.end()) {
        return &known->second;
    }
    return plan_.robot_from_other_laser ? &*plan_.robot_from_other_laser : nullptr;
}

bool MessageLogStream::is_odometry(const PoseReading& reading) const {
    return plan_.odom_frame.empty() ||
           (reading.frame_id == plan_.odom_frame && reading.child_frame_id == plan_.robot_frame);
}

bool MessageLogStream::first_is_ready() const {
    return waiting_.size() > max_waiting || (!waiting_.empty() && waiting_.front().has_odometry &&
                                             waiting_.front().has_ground_truth && waiting_.front().has_information);
}

SensorFrame MessageLogStream::release_first() {
    WaitingScan scan = std::move(waiting_.front());
    waiting_.pop_front();
    SensorFrame& frame = scan.frame;
    if (truth_ && scan.information) {
        truth_->add(frame.scan.stamp_ns, *scan.information);
    }
    ++summary_.scans;
    frame.odom_from_robot = odometry_at(frame.scan.stamp_ns);
    frame.world_from_robot = ground_truth_.at(frame.scan.stamp_ns);
    return std::move(scan.frame);
}

Pose2 MessageLogStream::odometry_at(std::int64_t stamp_ns) {
    if (plan_.odom_topic.empty()) {
        return {};
    }
    if (const std::optional<Pose2> pose = odometry_.at(stamp_ns)) {
        return *pose;
    }
    const std::optional<StampedPose> nearest = odometry_.nearest(stamp_ns);
    const double gap_s = nearest ? seconds_between(nearest->stamp_ns, stamp_ns) : INFINITY;
    if (gap_s > max_odometry_gap_s) {
        report({file_ + ": scan " + std::to_string(summary_.scans) + " has no odometry within " +
                std::to_string(max_odometry_gap_s) + " s; the nearest is " + std::to_string(gap_s) + " s away"});
    }
    return nearest ? nearest->pose : Pose2{};
}

void MessageLogStream::report_message(const McapMessage& message, const std::string& what) {
    report({file_ + ": " + message.channel->topic + " (" + message.channel->schema.name + "): skipped " + what +
                " near " + message.offset_unit + " " + std::to_string(message.file_offset),
            message.file_offset});
}

}  // namespace ddtool
