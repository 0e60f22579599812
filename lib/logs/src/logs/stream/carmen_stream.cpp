#include "logs/stream/carmen_stream.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "ddtool/base/error.hpp"
#include "logs/stream/idle_options.hpp"
#include "logs/stream/scan_angles.hpp"
#include "logs/stream/scan_change.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr double sick_range_max_m = 80.0;
/// Of the robots that are in these logs.
constexpr double fastest_m_per_s = 3.0;
constexpr double fastest_rad_per_s = 6.0;
constexpr std::string_view flaser = "FLASER";
constexpr std::string_view robotlaser = "ROBOTLASER1";

void check_options(const std::string& file, const LogOptions& options) {
    if (!options.scan_topic.empty() && options.scan_topic != flaser && options.scan_topic != robotlaser) {
        throw UsageError(file + ": has no scans '" + options.scan_topic +
                         "'; in a CARMEN log they are FLASER or ROBOTLASER1");
    }
    for (const std::string& other_topic : {options.cloud_topic, options.odom_topic, options.ground_truth_topic}) {
        if (!other_topic.empty()) {
            throw UsageError(file + ": has no topic '" + other_topic +
                             "'; in a CARMEN log the odometry is in the scans, and there are neither point clouds nor "
                             "ground truth");
        }
    }
    if (!options.robot.empty()) {
        throw UsageError(file + ": has no scans of a robot '" + options.robot +
                         "'; a CARMEN log is of one robot, without a name");
    }
    if (!options.imu_topic.empty() && options.imu_topic != "none") {
        throw UsageError(file + ": has no inertial topic '" + options.imu_topic +
                         "'; inertial sensors of CARMEN logs are not read");
    }
    if (options.odom_path > 1) {
        throw UsageError(file + ": there is no path " + std::to_string(options.odom_path) +
                         "; in a CARMEN log the poses of the odometry are those of one publisher");
    }
}

double rad_of_degrees(double degrees) { return degrees * std::numbers::pi / 180.0; }

CarmenLine parse_scan(std::string_view name, std::string_view words) {
    return name == flaser ? parse_flaser(words) : parse_robotlaser(words);
}

}  // namespace

CarmenStream::CarmenStream(const FoundLog& log, LogOptions options, LogProblemHandler on_problem)
    : LogStream(std::move(on_problem)),
      file_(log.path.string()),
      options_(std::move(options)),
      lines_(open_lines(log, [this](const LogProblem& problem) { report(problem); })) {
    check_options(file_, options_);
    summary_.format = "CARMEN";
    summary_.scan_topic = options_.scan_topic;
    odom_delay_ns_ = std::llround(1e9 * options_.odom_delay_s.value_or(0.0));
    summary_.odom_delay_removed_s = options_.odom_delay_s.value_or(0.0);
    read_ahead();
    if (odom_delay_ns_ != 0 && !stamps_are_plain_) {
        throw UsageError(file_ +
                         ": --odom-delay: the times of the lines are no stamps, so that no delay can be taken off");
    }
    judge_odometry(log);
    for (const std::string& line : options_without_effect(options_, {.odometry = summary_.has_odometry})) {
        summary_.assumptions.push_back(file_ + ": " + line);
    }
}

double CarmenStream::fraction_read() const { return lines_.fraction_read(); }

std::optional<SensorFrame> CarmenStream::next() {
    std::optional<SensorFrame> frame = watch_.take();
    for (bool has_more = true; !frame && has_more; frame = watch_.take()) {
        if (std::optional<SensorFrame> read = next_read()) {
            watch_.add(*std::move(read));
        } else {
            watch_.end();
            has_more = false;
        }
        for (const std::string& finding : watch_.take_findings()) {
            report({file_ + ": " + finding});
        }
    }
    summary_.scans += frame ? 1 : 0;
    return frame;
}

std::optional<SensorFrame> CarmenStream::next_read() {
    if (ahead_.empty()) {
        return std::nullopt;
    }
    Ahead next = std::move(ahead_.front());
    ahead_.pop_front();
    if (ahead_.empty()) {
        if (std::optional<Ahead> following = read_frame()) {
            ahead_.push_back(std::move(*following));
        }
    }
    SensorFrame& frame = next.frame;
    const std::int64_t logged_ns = frame.scan.stamp_ns;
    if (odom_delay_ns_ != 0) {
        take_delayed_odometry(frame, logged_ns);
    }
    frame.scan.stamp_ns = times_.time_ns(logged_ns, true, next.recorded_ns);
    set_no_returns(frame.scan);
    if (!summary_.has_odometry) {
        frame.odom_from_robot = {};
        frame.odom_step = OdometryStep::unknown;
    } else if (!next.jump.empty()) {
        report({next.jump});
    }
    time_beams(frame, logged_ns);
    return std::move(frame);
}

/// The pose at the stamp of the scan in the odometry whose stamps have the delay taken off.
void CarmenStream::take_delayed_odometry(SensorFrame& frame, std::int64_t logged_ns) {
    const std::int64_t wanted_ns = stamp_sum(logged_ns, odom_delay_ns_);
    while (ahead_.size() < most_waiting && (ahead_.empty() || ahead_.back().frame.scan.stamp_ns < wanted_ns)) {
        std::optional<Ahead> following = read_frame();
        if (!following) {
            break;
        }
        ahead_.push_back(std::move(*following));
    }
    const std::optional<Pose2> pose = odometry_.at(wanted_ns);
    frame.odom_from_robot = pose ? *pose : odometry_.nearest(wanted_ns)->pose;
    frame.odom_step = last_wanted_ns_ ? unknown_motion_.step(*last_wanted_ns_, wanted_ns) : OdometryStep::measured;
    last_wanted_ns_ = wanted_ns;
}

/// The odometry is known at the stamps of the scans alone; between this one and the next, the motion is taken as
/// uniform.
void CarmenStream::time_beams(SensorFrame& frame, std::int64_t logged_ns) {
    const auto odometry_after = [&](double seconds) -> std::optional<Pose2> {
        if (seconds == 0.0) {
            return frame.odom_from_robot;
        }
        if (!summary_.has_odometry || ahead_.empty()) {
            return std::nullopt;
        }
        if (odom_delay_ns_ != 0) {
            return odometry_.extended_at(stamp_sum(stamp_sum(logged_ns, odom_delay_ns_), std::llround(1e9 * seconds)));
        }
        const SensorFrame& following = ahead_.front().frame;
        const Pose2& next = following.odom_from_robot;
        const double until_next_s = seconds_between(logged_ns, following.scan.stamp_ns);
        const double speed = distance_m(frame.odom_from_robot, next) / until_next_s;
        const double turn_rate = std::abs(wrap_angle(next.theta_rad - frame.odom_from_robot.theta_rad)) / until_next_s;
        // In some logs two stamps are too near to each other for the way between them.
        if (!(until_next_s > 0.0) || speed > fastest_m_per_s || turn_rate > fastest_rad_per_s) {
            return std::nullopt;
        }
        return interpolate(frame.odom_from_robot, next, seconds / until_next_s);
    };
    if (sweep_timer_.apply(frame, odometry_after)) {
        summary_.assumptions.push_back(file_ + ": " + sweep_timer_.finding());
    }
}

void CarmenStream::read_ahead() {
    RangePiles piles;
    ScanChange change;
    ScanRate rate;
    RangeUnit unit;
    bool robot_moves = false;
    while (ahead_.size() < scans_read_ahead) {
        std::optional<Ahead> next = read_frame();
        if (!next) {
            break;
        }
        const SensorFrame& frame = next->frame;
        unit.add(frame.scan);
        piles.add(frame.scan);
        change.add(frame.scan);
        rate.add(frame.scan, "");
        robot_moves = robot_moves || (!ahead_.empty() && frame.odom_from_robot != ahead_.front().frame.odom_from_robot);
        ahead_.push_back(std::move(*next));
    }
    if (ahead_.empty()) {
        fail_without_scans();
    }
    find_sweep(rate);
    no_returns_ = options_.no_return_m.empty() ? piles.find(true) : named_no_returns(options_.no_return_m);
    for (const std::string& line : piles.never_read(options_.no_return_m)) {
        summary_.assumptions.push_back(file_ + ": " + line);
    }
    choose_times();
    if (!options_.with_odometry) {
        summary_.has_odometry = false;
        summary_.assumptions.push_back(file_ + ": the odometry of the log is left out, as was asked for");
    } else if (!robot_moves && change.moves()) {
        summary_.has_odometry = false;
        report({file_ + ": the odometry in the lines of the scans is not used: it never moves, although the scans do"});
    }
    note_assumptions();
    if (const std::string fault = unit.fault(); !fault.empty()) {
        report({file_ + ": " + fault});
    }
    expect_ranges();
}

/// Compares the lengths and the turns of the odometry with those of the scans, in a reading of its own.
void CarmenStream::judge_odometry(const FoundLog& log) {
    if (!summary_.has_odometry || !stamps_are_plain_) {
        return;
    }
    ScanTurns turns;
    ScanWay way;
    HeadingTrack headings;
    HeadingTrack headings_as_degrees;
    WayTrack track;
    LineReader lines = open_lines(log, {});
    while (!turns.is_full() || !way.is_full()) {
        std::optional<std::string_view> line = lines.next();
        if (!line) {
            break;
        }
        const std::string_view name = next_word(*line);
        std::optional<CarmenScan> message = name == summary_.scan_topic ? parse_scan(name, *line).scan : std::nullopt;
        if (message && read_angles(message->scan) != ScanAngles::impossible) {
            set_no_returns(message->scan);
            turns.add(message->scan);
            way.add(message->scan);
            headings.add(message->scan.stamp_ns, message->odom_from_robot.theta_rad);
            headings_as_degrees.add(message->scan.stamp_ns, rad_of_degrees(message->odom_from_robot.theta_rad));
            track.add({message->scan.stamp_ns, message->odom_from_robot});
        }
    }
    const std::optional<TurnLag> lag = turn_lag(turns, headings, 0.0);
    std::string fault = length_fault(way, track, 0.0);
    if (!lag && turn_lag(turns, headings_as_degrees, 0.0)) {
        fault += std::string(fault.empty() ? "" : "; ") +
                 "its turns fit the scans' only if it is in degrees; expected "
                 "radians";
    }
    if (!fault.empty()) {
        summary_.has_odometry = false;
        report({file_ + ": the odometry in the lines of the scans is not used: " + fault});
        return;
    }
    note_delay(lag);
}

/// The pose in the line of a scan is the latest that the robot had when the scan came, and so may be of another time.
void CarmenStream::note_delay(std::optional<TurnLag> lag) {
    if (!lag) {
        return;
    }
    lag->late_s -= sweep_timer_.middle_s();
    summary_.odom_delay = {lag->late_s, lag->sigma_s};
    if (lag->is_significant() && !options_.odom_delay_s) {
        summary_.assumptions.push_back(
            file_ + ": the poses of the odometry are " + fixed_text(1e3 * std::abs(lag->late_s), 0) + " ms (+- " +
            fixed_text(1e3 * lag->sigma_s, 0) + ") " + (lag->late_s > 0.0 ? "late" : "early") +
            " against the scans in whose lines they are, as the turns of both show; this is not taken off; "
            "--odom-delay " +
            fixed_text(lag->late_s, 3) + " does");
    }
}

void CarmenStream::choose_times() {
    StampSurvey stamps;
    for (const Ahead& each : ahead_) {
        stamps.add(each.frame.scan.stamp_ns, each.frame.scan.stamp_ns != 0, each.recorded_ns);
    }
    const StampRule rule = stamps.rule("the scans " + summary_.scan_topic);
    times_ = StampReader(rule);
    stamps_are_plain_ = rule.assumption.empty() && rule.fault.empty();
    if (!rule.assumption.empty()) {
        summary_.assumptions.push_back(file_ + ": " + rule.assumption);
    }
    if (!rule.fault.empty()) {
        report({file_ + ": " + rule.fault});
    }
}

/// Throws Error if there is nothing in any of the scans that were read ahead.
void CarmenStream::expect_ranges() {
    for (const Ahead& each : ahead_) {
        LaserScan scan = each.frame.scan;
        set_no_returns(scan);
        if (std::ranges::any_of(scan.ranges_m, [](float range_m) { return std::isfinite(range_m); })) {
            return;
        }
    }
    throw Error(file_ + ": none of the first " + std::to_string(ahead_.size()) + " scans " + summary_.scan_topic +
                " has a range: no beam of them has a return; there is nothing to map");
}

/// The lines do not say when each beam was measured. A SICK laser turns 75 times a second, whatever part of its scans
/// was recorded, so that its beams count as measured at once.
void CarmenStream::find_sweep(const ScanRate& rate) {
    if (!is_sick_view(ahead_.front().frame.scan.ranges_m.size())) {
        sweep_timer_ = SweepTimer(find_sweep_timing(rate));
    }
}

void CarmenStream::note_assumptions() {
    if (summary_.scan_topic == flaser && !mounting_ && !options_.laser_pose) {
        summary_.assumptions.push_back(
            file_ + ": no PARAM robot_frontlaser_offset; the laser is taken to be at the robot's origin");
    }
    if (in_degrees_ > 0) {
        summary_.assumptions.push_back(file_ + ": the angles of " + std::to_string(in_degrees_) + " of the first " +
                                       std::to_string(ahead_.size()) + " scans " + summary_.scan_topic +
                                       " are taken for degrees, because as radians their beams would cover several "
                                       "turns");
    }
    if (options_.no_return_m.empty()) {
        for (const std::string& line : no_returns_.lines()) {
            summary_.assumptions.push_back(file_ + ": " + line);
        }
    }
}

std::optional<CarmenStream::Ahead> CarmenStream::read_frame() {
    while (const std::optional<std::string_view> line = lines_.next()) {
        if (std::optional<Ahead> next = take_line(*line)) {
            return next;
        }
    }
    return std::nullopt;
}

std::optional<CarmenStream::Ahead> CarmenStream::take_line(std::string_view line) {
    const std::string name(next_word(line));
    if (name == flaser || name == robotlaser) {
        return take_scan(name, line);
    }
    if (name == "PARAM") {
        take_parameter(line);
    }
    return std::nullopt;
}

std::optional<CarmenStream::Ahead> CarmenStream::take_scan(const std::string& name, std::string_view words) {
    if (summary_.scan_topic.empty()) {
        summary_.scan_topic = name;
    }
    if (name != summary_.scan_topic) {
        other_scan_name_ = name;
        return std::nullopt;
    }
    auto [message, fault] = parse_scan(name, words);
    if (!message) {
        report(
            {file_ + ":" + std::to_string(lines_.line_number()) + ": skipped a damaged " + name + " line: " + fault});
        return std::nullopt;
    }
    switch (read_angles(message->scan)) {
        case ScanAngles::impossible:
            report({file_ + ":" + std::to_string(lines_.line_number()) + ": skipped " + angle_fault(message->scan)});
            return std::nullopt;
        case ScanAngles::degrees:
            ++in_degrees_;
            break;
        case ScanAngles::radians:
            break;
    }
    ++summary_.odometry;
    summary_.odom_topic = name;
    Ahead ahead{{}, recorded_ns(*message), ""};
    SensorFrame& frame = ahead.frame;
    frame.robot_from_laser = robot_from_laser(*message);
    frame.odom_from_robot = resets_.follow({message->scan.stamp_ns, message->odom_from_robot});
    if (const auto& jump = resets_.last_jump()) {
        frame.odom_step = jump->is_bridged ? OdometryStep::measured : OdometryStep::unknown;
        if (!jump->is_bridged) {
            unknown_motion_.add_unknown(last_logged_ns_, message->scan.stamp_ns);
        }
        ahead.jump =
            file_ + ":" + std::to_string(lines_.line_number()) + ": the odometry " + OdometryResets::text(*jump);
    }
    last_logged_ns_ = message->scan.stamp_ns;
    if (odom_delay_ns_ != 0) {
        odometry_.add({last_logged_ns_, frame.odom_from_robot});
    }
    frame.scan = std::move(message->scan);
    return ahead;
}

/// The logger's time, which begins with the log, on the clock of the first scan.
std::int64_t CarmenStream::recorded_ns(const CarmenScan& message) {
    const std::int64_t logger_ns = message.logger_time_ns.value_or(0);
    if (!logger_start_ns_) {
        logger_start_ns_ = stamp_difference(message.scan.stamp_ns, logger_ns);
    }
    return stamp_sum(logger_ns, *logger_start_ns_);
}

void CarmenStream::take_parameter(std::string_view words) {
    constexpr std::array<std::pair<std::string_view, double Pose2::*>, 3> mounting{{
        {"robot_frontlaser_offset", &Pose2::x_m},
        {"robot_frontlaser_side_offset", &Pose2::y_m},
        {"robot_frontlaser_angular_offset", &Pose2::theta_rad},
    }};
    const std::string_view name = next_word(words);
    const std::optional<double> value = parse_number(next_word(words));
    if (!value) {
        return;
    }
    if (name == "robot_front_laser_max") {
        range_max_m_ = *value;
    }
    for (const auto& [offset_name, member] : mounting) {
        if (name == offset_name) {
            mounting_ = mounting_.value_or(Pose2{});
            (*mounting_).*member = *value;
        }
    }
}

/// The poses of FLASER do not give the mounting of the laser, because in corrected logs the first of them is the
/// corrected pose.
Pose2 CarmenStream::robot_from_laser(const CarmenScan& message) const {
    if (options_.laser_pose) {
        return *options_.laser_pose;
    }
    if (summary_.scan_topic == robotlaser) {
        return between(message.odom_from_robot, message.odom_from_laser);
    }
    return mounting_.value_or(Pose2{});
}

void CarmenStream::set_no_returns(LaserScan& scan) const {
    double limit_m = sick_range_max_m;
    for (const double stated_m : {scan.range_max_m, range_max_m_.value_or(0.0)}) {
        if (stated_m > 0.0) {
            limit_m = std::min(limit_m, stated_m);
        }
    }
    if (options_.range_max_m > 0.0) {
        limit_m = options_.range_max_m;
    }
    scan.range_max_m = limit_m;
    no_returns_.apply(scan);
    limit_m = scan.range_max_m;
    for (float& range : scan.ranges_m) {
        if (static_cast<double>(range) >= limit_m) {
            range = LaserScan::no_return;
        }
    }
    normalise_ranges(scan);
}

void CarmenStream::fail_without_scans() const {
    const std::string hint = other_scan_name_.empty() ? "" : " (it has " + other_scan_name_ + " lines)";
    const std::string wanted =
        summary_.scan_topic.empty() ? std::string(flaser) + " or " + std::string(robotlaser) : summary_.scan_topic;
    const std::string first =
        summary_.first_problems.empty() ? "" : "; the first problem: " + summary_.first_problems.front();
    throw Error(file_ + ": holds no readable scans; expected " + wanted + " lines" + hint + first);
}

}  // namespace ddtool
