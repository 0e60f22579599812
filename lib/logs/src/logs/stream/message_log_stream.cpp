#include "logs/stream/message_log_stream.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/cloud_scan.hpp"
#include "logs/stream/kept_messages.hpp"
#include "logs/stream/laser_mounting.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

std::vector<SweepTimer> timers_of(const LogPlan& plan) {
    std::vector<SweepTimer> timers;
    for (const LidarPlan& lidar : plan.lidars) {
        timers.emplace_back(lidar.sweep);
    }
    return timers;
}

}  // namespace

MessageLogStream::MessageLogStream(const OpenSource& open, Opening opening, std::string format, std::string file,
                                   const LogOptions& options, LogProblemHandler on_problem)
    : LogStream(std::move(on_problem)), file_(std::move(file)) {
    if (opening == Opening::twice) {
        survey(open, options);
        rehearse(open);
    } else {
        is_read_once_ = true;
        survey_once(open, options, opening == Opening::live ? SurveyExtent::soon : SurveyExtent::beginning);
        sweep_timers_ = timers_of(plan_);
    }
    if (opening == Opening::live) {
        is_live_ = true;
        watch_ = FrameWatch(0);
    }
    take_off_lag();
    gaps_ = OdometryGaps(plan_.odom_interval_s);
    summary_.format = std::move(format);
    for (const LidarPlan& lidar : plan_.lidars) {
        if (&lidar == &plan_.lidars.front()) {
            summary_.scan_topic = lidar.topic;
        } else {
            summary_.more_scan_topics.push_back(lidar.topic);
        }
    }
    summary_.odom_topic = plan_.odom_topic;
    summary_.odom_frame = plan_.odom_frame;
    summary_.robot_frame = plan_.robot_frame;
    summary_.has_odometry = !plan_.odom_topic.empty();
    summary_.odom_delay_removed_s = -1e-9 * static_cast<double>(plan_.odom_clock_offset_ns);
    summary_.ground_truth_topic = plan_.ground_truth_topic;
    summary_.assumptions.insert(summary_.assumptions.begin(), plan_.assumptions.begin(), plan_.assumptions.end());
    start_clocks();
    for (const std::string& fault : plan_.faults) {
        report({fault});
    }
}

MessageLogStream::MessageLogStream(LogPlan plan, std::unique_ptr<MessageSource> source, std::string file)
    : LogStream({}),
      file_(std::move(file)),
      plan_(std::move(plan)),
      source_(std::move(source)),
      sweep_timers_(timers_of(plan_)) {
    start_clocks();
    gaps_ = OdometryGaps(plan_.odom_interval_s);
}

/// Takes off what the turns show the odometry to be late, where that is sure. It depends on when the beams of a scan
/// are measured.
void MessageLogStream::take_off_lag() {
    if (!plan_.odom_lag) {
        return;
    }
    TurnLag lag = *plan_.odom_lag;
    lag.late_s -= sweep_timers_.front().middle_s();
    const double before_s = -1e-9 * static_cast<double>(plan_.odom_clock_offset_ns);
    summary_.odom_delay = {before_s + lag.late_s, lag.sigma_s};
    // Where a log is read once, it is not yet known when the beams are measured, and a sweep looks like a delay.
    if (plan_.takes_off_lag && !is_read_once_ && lag.is_significant()) {
        plan_.odom_clock_offset_ns = std::llround(-1e9 * (before_s + lag.late_s));
        summary_.assumptions.push_back(file_ + ": the stamps of the odometry " + plan_.odom_topic + " are " +
                                       fixed_text(1e3 * std::abs(lag.late_s), 0) + " ms (+- " +
                                       fixed_text(1e3 * lag.sigma_s, 0) + ") " + (lag.late_s > 0.0 ? "late" : "early") +
                                       " against those of the scans, as the turns of both show; this is taken off; "
                                       "--odom-delay names another delay, --odom-delay 0 none");
    }
    plan_.odom_lag.reset();
}

void MessageLogStream::start_clocks() {
    scan_times_.clear();
    for (const LidarPlan& lidar : plan_.lidars) {
        scan_times_.emplace_back(lidar.stamps);
    }
    odom_times_ = StampReader(plan_.odom_stamps);
    ground_truth_times_ = StampReader(plan_.ground_truth_stamps);
}

void MessageLogStream::survey(const OpenSource& open, const LogOptions& options) {
    const auto survey_source = open([](const LogProblem&) {});  // problems are reported at the second reading
    plan_ = plan_log(survey_log(*survey_source, SurveyExtent::whole, options), options, file_);
    source_ = open([this](const LogProblem& problem) { report(problem); });
}

/// Reads as many frames as tell how the beams were measured, and whether the gyro is better than the wheels, so that
/// this is known from the first frame on.
void MessageLogStream::rehearse(const OpenSource& open) {
    sweep_timers_ = timers_of(plan_);
    if (is_settled() || plan_.odom_topic.empty()) {
        return;
    }
    MessageLogStream rehearsal(plan_, open([](const LogProblem&) {}), file_);
    rehearsal.take_off_lag();
    while (!rehearsal.is_settled() && rehearsal.summary().scans < most_rehearsed && rehearsal.next()) {
    }
    gyro_trial_ = rehearsal.gyro_trial_;
    sweep_timers_ = rehearsal.sweep_timers_;
    for (SweepTimer& timer : sweep_timers_) {
        if (const std::string finding = timer.finding(); !finding.empty()) {
            summary_.assumptions.push_back(file_ + ": " + finding);
        }
        timer.settle();
    }
    if (!plan_.imu_topic.empty()) {
        judge_gyro();
    }
}

void MessageLogStream::survey_once(const OpenSource& open, const LogOptions& options, SurveyExtent extent) {
    auto source = std::make_unique<KeptMessages>(open([this](const LogProblem& problem) { report(problem); }),
                                                 options.cloud_topic.empty());
    plan_ = plan_log(survey_log(*source, extent, options), options, file_);
    source->rewind();
    source_ = std::move(source);
}

std::optional<SensorFrame> MessageLogStream::next() {
    std::optional<SensorFrame> frame = watch_.take();
    for (bool has_more = true; !frame && has_more; frame = watch_.take()) {
        if (std::optional<SensorFrame> read = read_frame()) {
            watch_.add(*std::move(read));
        } else {
            watch_.end();
            end_lost_part();
            has_more = false;
        }
        for (const std::string& finding : watch_.take_findings()) {
            report({file_ + ": " + finding});
        }
    }
    summary_.scans += frame ? 1 : 0;
    return frame;
}

std::optional<SensorFrame> MessageLogStream::read_frame() {
    while (!ended_ && !first_is_ready()) {
        if (const std::optional<McapMessage> message = source_->next()) {
            take(*message);
        } else {
            end();
        }
    }
    return waiting_.empty() ? std::nullopt : std::optional(release_first());
}

void MessageLogStream::end() {
    ended_ = true;
    release_odometry(true);
    if (clouds_.read > 0 && clouds_.in_band == 0) {
        const auto heights = [](const HeightBand& band) {
            return fixed_text(band.min_m, 2) + " and " + fixed_text(band.max_m, 2) + " m";
        };
        report({file_ + ": none of the " + std::to_string(clouds_.read) + " clouds has a point between " +
                heights(clouds_.band) + " above " +
                (plan_.robot_from_other_laser ? "the lidar" : "the robot's origin") + "; their points are between " +
                heights(clouds_.heights) + "; expected walls in the band, --height MIN,MAX takes another"});
    }
}

void MessageLogStream::take(const McapMessage& message) {
    now_ns_ = message.log_time_ns;
    const std::string& topic = message.channel->topic;
    if (is_information(*message.channel)) {
        take_information(message);
        return;
    }
    const MessageKind kind = kind_of(*message.channel);
    if (kind == MessageKind::inertial && topic == plan_.imu_topic) {
        take_rates(message);
    }
    if (kind == MessageKind::scan || kind == MessageKind::cloud) {
        const auto lidar = std::ranges::find(plan_.lidars, topic, &LidarPlan::topic);
        if (lidar != plan_.lidars.end()) {
            const auto number = static_cast<std::size_t>(lidar - plan_.lidars.begin());
            kind == MessageKind::scan ? take_scan(message, number) : take_cloud(message, number);
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

void MessageLogStream::take_scan(const McapMessage& message, std::size_t lidar) {
    std::optional<ScanReading> reading = decode_scan(message, plan_.echo);
    if (!reading) {
        report_message(message, fault_of(message));
        return;
    }
    reading->scan.stamp_ns =
        scan_times_[lidar].time_ns(reading->scan.stamp_ns, reading->has_stamp, message.log_time_ns);
    const Eigen::Isometry3d* robot_from_laser = mounting_of(reading->frame_id, message);
    if (robot_from_laser == nullptr) {
        return;
    }
    SensorFrame frame;
    frame.lidar = lidar;
    if (const auto fault = place_scan(std::move(*reading), *robot_from_laser, plan_.lidars[lidar].ranges, frame)) {
        report_message(message, *fault);
        return;
    }
    wait(std::move(frame));
}

void MessageLogStream::take_cloud(const McapMessage& message, std::size_t lidar) {
    std::optional<CloudReading> reading = decode_cloud(message);
    if (!reading || !reading->fault.empty() || reading->points_m.empty()) {
        report_message(message, !reading                 ? fault_of(message)
                                : reading->fault.empty() ? "a cloud without points"
                                                         : "a cloud " + reading->fault);
        return;
    }
    reading->stamp_ns = scan_times_[lidar].time_ns(reading->stamp_ns, reading->has_stamp, message.log_time_ns);
    const Eigen::Isometry3d* robot_from_laser = mounting_of(reading->frame_id, message);
    if (robot_from_laser == nullptr) {
        return;
    }
    const HeightBand band = plan_.height                   ? *plan_.height
                            : plan_.robot_from_other_laser ? band_around_unknown
                                                           : band_around_lidar(robot_from_laser->translation().z());
    SensorFrame frame;
    frame.lidar = lidar;
    place_cloud(*reading, *robot_from_laser, band, plan_.cloud_beams, plan_.lidars[lidar].ranges, frame);
    ++clouds_.read;
    clouds_.in_band += std::ranges::any_of(frame.scan.ranges_m, [](float m) { return std::isfinite(m); }) ? 1 : 0;
    clouds_.band = band;
    if (clouds_.in_band == 0) {
        const HeightBand heights = heights_of(*reading, *robot_from_laser);
        clouds_.heights = clouds_.read == 1 ? heights
                                            : HeightBand{std::min(clouds_.heights.min_m, heights.min_m),
                                                         std::max(clouds_.heights.max_m, heights.max_m)};
    }
    wait(std::move(frame));
}

void MessageLogStream::wait(SensorFrame frame) {
    WaitingScan scan;
    scan.frame = std::move(frame);
    scan.since_ns = now_ns_;
    const std::int64_t stamp_ns = scan.frame.scan.stamp_ns;
    scan.measured_ns =
        stamp_sum(stamp_ns, std::llround(1e9 * sweep_timers_[scan.frame.lidar].longest_s(scan.frame.scan)));
    scan.has_odometry = plan_.odom_topic.empty() || odometry_.contains(scan.measured_ns);
    scan.has_ground_truth = plan_.ground_truth_topic.empty() || ground_truth_.contains(stamp_ns);
    scan.has_information = !plan_.has_information;
    waiting_.push_back(std::move(scan));
}

void MessageLogStream::take_odometry(const McapMessage& message) {
    const auto readings = odometry_reader_.read(message);
    if (!readings) {
        report_message(message, fault_of(message));
        return;
    }
    for (const PoseReading& reading : *readings) {
        if (is_odometry(reading) && has_rotation(reading, message) && is_of_used_path(reading, message)) {
            ++summary_.odometry;
            const std::int64_t stamp_ns =
                stamp_sum(odom_times_.time_ns(reading.stamp_ns, reading.has_stamp, message.log_time_ns),
                          plan_.odom_clock_offset_ns);
            const StampedPose odom_from_robot{stamp_ns, resets_.follow({stamp_ns, to_pose2(reading.frame_from_child)})};
            const auto gap = gaps_.add(odom_from_robot);
            if (const auto& jump = resets_.last_jump()) {
                if (!jump->is_bridged) {
                    gaps_.add_unknown(*last_odometry_ns_, stamp_ns);
                }
                report({file_ + ": the odometry " + plan_.odom_topic + " " + OdometryResets::text(*jump) + " (near " +
                            message.offset_unit + " " + std::to_string(message.file_offset) + ")",
                        message.file_offset});
            } else if (gap) {
                report_gap(*gap, message);
            }
            last_odometry_ns_ = stamp_ns;
            if (plan_.imu_topic.empty()) {
                add_odometry(odom_from_robot);
            } else {
                gyro_odometry_.add_pose(odom_from_robot);
                release_odometry(false);
            }
        }
    }
}

void MessageLogStream::add_odometry(const StampedPose& odom_from_robot) {
    odometry_.add(odom_from_robot);
    for (WaitingScan& scan : waiting_) {
        scan.has_odometry = scan.has_odometry || scan.measured_ns <= odom_from_robot.stamp_ns;
    }
}

void MessageLogStream::release_odometry(bool at_end) {
    while (const std::optional<StampedPose> pose = gyro_odometry_.next(at_end)) {
        add_odometry(*pose);
    }
}

void MessageLogStream::take_rates(const McapMessage& message) {
    const std::optional<ImuReading> reading = decode_imu(message);
    if (!reading) {
        report_message(message, fault_of(message));
        return;
    }
    gyro_odometry_.add_rate(stamp_sum(reading->stamp_ns, plan_.imu_clock_offset_ns),
                            plan_.imu_upwards.dot(reading->angular_velocity_rad_per_s));
    release_odometry(false);
}

bool MessageLogStream::is_settled() const {
    return std::ranges::all_of(sweep_timers_, &SweepTimer::is_settled) &&
           (plan_.imu_topic.empty() || gyro_is_judged_ || gyro_trial_.is_complete());
}

void MessageLogStream::judge_gyro() {
    const std::string name = "the gyro in " + plan_.imu_topic;
    const std::optional<GyroVerdict> verdict = gyro_trial_.verdict();
    gyro_is_judged_ = true;
    if (!verdict) {
        if (plan_.imu_is_named) {
            gyro_odometry_.use(1.0, 0.0);
            summary_.imu_topic = plan_.imu_topic;
        }
        return;
    }
    const auto mrad = [](double rad) { return fixed_text(1e3 * rad, 1) + " mrad"; };
    const std::string errors = "its turns differ from those between scans by " + mrad(verdict->error_rad) +
                               ", the odometry's own by " + mrad(verdict->odometry_error_rad) + " (median of " +
                               std::to_string(verdict->pairs) + ", of a second or 0.2 rad each)";
    if (!verdict->fits || !(verdict->is_better || plan_.imu_is_named)) {
        const std::string line = file_ + ": " + name + " is not used: " + errors;
        if (!verdict->fits && plan_.imu_is_named) {
            report({line});
        } else {
            summary_.assumptions.push_back(line);
        }
        return;
    }
    gyro_odometry_.use(verdict->scale, verdict->bias_rad_per_s);
    summary_.imu_topic = plan_.imu_topic;
    const bool is_in_degrees = std::abs(verdict->scale) < 0.5;
    summary_.assumptions.push_back(file_ + ": the turns are those of " + name + ", not the odometry's own: " + errors +
                                   "; " + fixed_text(verdict->bias_rad_per_s, 4) + " rad/s are taken off for its bias" +
                                   (is_in_degrees ? ", and it is taken to be in degrees" : "") +
                                   (verdict->scale < 0.0 ? ", with the opposite sign" : ""));
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

const Eigen::Isometry3d* MessageLogStream::mounting_of(const std::string& frame_id, const McapMessage& message) {
    if (const auto known = plan_.robot_from_laser.find(frame_id); known != plan_.robot_from_laser.end()) {
        return &known->second;
    }
    if (plan_.robot_from_other_laser) {
        return &*plan_.robot_from_other_laser;
    }
    report_message(message, "a scan in the frame '" + frame_id + "', which no transform places on the robot,");
    return nullptr;
}

bool MessageLogStream::is_of_used_path(const PoseReading& reading, const McapMessage& message) {
    const std::vector<std::size_t>& lineage = plan_.odom_lineage;
    if (lineage.empty()) {
        return true;
    }
    const std::size_t path = paths_.add({reading.stamp_ns, to_pose2(reading.frame_from_child)}, message.channel->id);
    const auto begun = [&](std::size_t each) { return each < paths_.size(); };
    const auto latest = std::find_if(lineage.rbegin(), lineage.rend(), begun);
    return latest != lineage.rend() && path == *latest;
}

bool MessageLogStream::is_odometry(const PoseReading& reading) const {
    return !plan_.odom_is_transform ||
           (reading.frame_id == plan_.odom_frame && reading.child_frame_id == plan_.robot_frame);
}

bool MessageLogStream::first_is_ready() const {
    if (is_live_ && !waiting_.empty() &&
        (now_ns_ - waiting_.front().since_ns > longest_live_wait_ns || is_near_odometry(waiting_.front()))) {
        return true;
    }
    return waiting_.size() > max_waiting || (!waiting_.empty() && waiting_.front().has_odometry &&
                                             waiting_.front().has_ground_truth && waiting_.front().has_information);
}

/// Whether the odometry nearly reaches the scan.
bool MessageLogStream::is_near_odometry(const WaitingScan& scan) const {
    return last_odometry_ns_ && scan.measured_ns - *last_odometry_ns_ < longest_guess_ns &&
           odometry_.extended_at(scan.measured_ns).has_value();
}

SensorFrame MessageLogStream::release_first() {
    WaitingScan scan = std::move(waiting_.front());
    waiting_.pop_front();
    SensorFrame& frame = scan.frame;
    if (truth_ && scan.information) {
        truth_->add(frame.scan.stamp_ns, *scan.information);
    }
    take_odometry_at(frame);
    frame.world_from_robot = ground_truth_.at(frame.scan.stamp_ns);
    time_beams(frame);
    return std::move(scan.frame);
}

void MessageLogStream::time_beams(SensorFrame& frame) {
    const auto odometry_after = [&](double seconds) {
        return odometry_.extended_at(stamp_sum(frame.scan.stamp_ns, std::llround(1e9 * seconds)));
    };
    SweepTimer& timer = sweep_timers_[frame.lidar];
    if (timer.apply(frame, odometry_after)) {
        summary_.assumptions.push_back(file_ + ": " + timer.finding());
    }
    if (frame.lidar == 0 && !plan_.imu_topic.empty() && !gyro_is_judged_ &&
        gyro_trial_.add(frame, gyro_odometry_.gyro()) &&
        (gyro_trial_.is_complete() || (is_read_once_ && gyro_trial_.is_decided()))) {
        judge_gyro();
    }
}

void MessageLogStream::take_odometry_at(SensorFrame& frame) {
    ++released_;
    if (plan_.odom_topic.empty()) {
        frame.odom_step = OdometryStep::unknown;
        return;
    }
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    double apart_s = 0.0;
    if (const std::optional<Pose2> pose = is_live_ ? odometry_.extended_at(stamp_ns) : odometry_.at(stamp_ns)) {
        frame.odom_from_robot = *pose;
    } else {
        const std::optional<StampedPose> nearest = odometry_.nearest(stamp_ns);
        apart_s = nearest ? std::abs(seconds_between(nearest->stamp_ns, stamp_ns)) : INFINITY;
        frame.odom_from_robot = nearest ? nearest->pose : Pose2{};
    }
    const bool is_lost = apart_s > max_odometry_gap_s;
    if (is_lost || was_lost_) {
        frame.odom_step = OdometryStep::unknown;
    } else if (last_scan_ns_) {
        frame.odom_step = gaps_.step(*last_scan_ns_, stamp_ns);
    }
    if (is_lost) {
        lost_.first_scan = lost_.scans == 0 ? released_ : lost_.first_scan;
        ++lost_.scans;
        lost_.farthest_s = std::max(lost_.farthest_s, std::isfinite(apart_s) ? apart_s : 0.0);
    } else {
        end_lost_part();
    }
    was_lost_ = is_lost;
    last_scan_ns_ = stamp_ns;
}

void MessageLogStream::end_lost_part() {
    if (lost_.scans > 0) {
        report({file_ + ": " + std::to_string(lost_.scans) + " scans from number " + std::to_string(lost_.first_scan) +
                " on have no odometry within " + fixed_text(max_odometry_gap_s, 1) + " s; it is up to " +
                fixed_text(lost_.farthest_s, 1) + " s away; the motion there is worked out from the scans"});
    }
    lost_ = {};
}

void MessageLogStream::report_gap(const OdometryGaps::Gap& gap, const McapMessage& message) {
    const auto is_inside = [&](const WaitingScan& scan) {
        return gap.from_ns < scan.frame.scan.stamp_ns && scan.frame.scan.stamp_ns < gap.to_ns;
    };
    const auto scans = std::ranges::count_if(waiting_, is_inside);
    if (scans > 0) {
        report({file_ + ": the odometry " + plan_.odom_topic + " is missing for " +
                    fixed_text(std::abs(seconds_between(gap.from_ns, gap.to_ns)), 1) + " s near " +
                    message.offset_unit + " " + std::to_string(message.file_offset) + ", with " +
                    std::to_string(scans) +
                    " scans; the motion there is worked out from the scans and the poses before and after",
                message.file_offset});
    }
}

void MessageLogStream::report_message(const McapMessage& message, const std::string& what) {
    report({file_ + ": " + message.channel->topic + " (" + message.channel->schema.name + "): skipped " + what +
                " near " + message.offset_unit + " " + std::to_string(message.file_offset),
            message.file_offset});
}

}  // namespace ddtool
