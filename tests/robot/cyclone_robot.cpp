// Plays a log as a robot that drives now, with the DDS of another maker than ddtool's, and tells as JSON what came back
// from ddtool slam --ros or ddtool localize --ros:
//   cyclone_robot LOG.mcap DOMAIN SECONDS [FAULT...]
// Each scan and each pose of the odometry is published when its time has come, with a stamp of now. Faults:
//   pause=AT:FOR     nothing is published for so long
//   mute=AT:FOR      no odometry is published for so long
//   jump=AT:BY       from then on all stamps are BY seconds later
//   restart=AT       the robot's programs end and start again, and its odometry begins at zero
//   pose=AT:X:Y      somebody tells the robot's place on /initialpose
//   carry=AT:FOR     the robot is carried to where it would be FOR seconds later, and its odometry notices nothing
//   clock            /clock is published, and stamps are those of the log
//   speed=FACTOR     with clock: everything happens so many times as fast
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cyclone.hpp"
#include "logs/containers/mcap_message_source.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool::test {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

constexpr double tolerance_s = 0.2;  // the default of ddtool slam --ros
constexpr auto longest_matching = std::chrono::seconds(20);
/// When one side has matched, the other follows; until then it does not hear what is best effort.
constexpr auto until_both_know = std::chrono::milliseconds(500);
/// Scans are answered late as long as ddtool looks at what the robot publishes, and works off what has come meanwhile.
constexpr auto while_surveyed = std::chrono::seconds(5);

struct Fault {
    std::string name;
    std::vector<double> numbers;
};

struct Request {
    std::string log;
    std::uint32_t domain = 0;
    double seconds = 0.0;
    std::vector<Fault> faults;

    [[nodiscard]] const Fault* fault(const std::string& name) const {
        const auto found = std::ranges::find(faults, name, &Fault::name);
        return found == faults.end() ? nullptr : &*found;
    }
};

Request request_of(int argc, char** argv) {
    if (argc < 4) {
        throw std::runtime_error("expected LOG.mcap DOMAIN SECONDS [FAULT...]");
    }
    Request request{argv[1], static_cast<std::uint32_t>(std::stoul(argv[2])), std::stod(argv[3]), {}};
    for (int place = 4; place < argc; ++place) {
        std::string word = argv[place];
        const std::size_t equals = std::min(word.find('='), word.size());
        Fault fault{word.substr(0, equals), {}};
        for (std::size_t at = equals; at < word.size(); at = std::min(word.find(':', at + 1), word.size())) {
            fault.numbers.push_back(std::stod(word.substr(at + 1)));
        }
        request.faults.push_back(std::move(fault));
    }
    return request;
}

/// What the robot publishes at one moment.
struct Step {
    std::int64_t stamp_ns = 0;  ///< in the log
    std::int64_t sweep_ns = 0;  ///< how long after its stamp the last beam was measured

    [[nodiscard]] std::int64_t due_ns() const { return stamp_ns + sweep_ns; }
    std::optional<RosLaserScan> scan;
    std::optional<RosOdometry> odometry;
};

struct Played {
    std::vector<Step> steps;
    std::optional<RosTFMessage> mounting;
    std::map<std::int64_t, Pose2> truth;  ///< where the robot is, by the stamps of the log, from its place at the start
};

/// Leaves out what happens while the robot is carried, and goes on with the odometry from where it was.
void carry(Played& played, double at_s, double for_s) {
    const std::int64_t from_ns = played.steps.front().stamp_ns + static_cast<std::int64_t>(1e9 * at_s);
    const std::int64_t left_out_ns = static_cast<std::int64_t>(1e9 * for_s);
    std::erase_if(played.steps,
                  [&](const Step& step) { return step.stamp_ns > from_ns && step.stamp_ns <= from_ns + left_out_ns; });
    std::optional<Pose2> before;
    std::optional<Pose2> after;
    for (Step& step : played.steps) {
        const std::optional<Pose2> logged =
            step.odometry ? std::optional(to_pose2(to_isometry(step.odometry->pose))) : std::nullopt;
        if (step.stamp_ns <= from_ns) {
            before = logged ? logged : before;
            continue;
        }
        step.stamp_ns -= left_out_ns;
        if (logged) {
            after = after ? after : logged;
            step.odometry->pose = to_ros_pose(before.value() * between(*after, *logged));
        }
    }
    std::map<std::int64_t, Pose2> truth;
    for (const auto& [stamp_ns, pose] : played.truth) {
        if (stamp_ns <= from_ns || stamp_ns > from_ns + left_out_ns) {
            truth[stamp_ns <= from_ns ? stamp_ns : stamp_ns - left_out_ns] = pose;
        }
    }
    played.truth = std::move(truth);
}

Played read_log(const Request& request) {
    Played played;
    McapMessageSource source(request.log, {});
    while (const auto message = source.next()) {
        const std::string& topic = message->channel->topic;
        Step step;
        if (topic == "/scan") {
            step.scan = decode_cdr<RosLaserScan>(message->data);
            step.stamp_ns = step.scan.value().header.stamp.ns;
            step.sweep_ns = static_cast<std::int64_t>(1e9 * static_cast<double>(step.scan->time_increment) *
                                                      static_cast<double>(step.scan->ranges.size()));
        } else if (topic == "/odom") {
            step.odometry = decode_cdr<RosOdometry>(message->data);
            step.stamp_ns = step.odometry.value().header.stamp.ns;
        } else if (topic == "/ground_truth") {
            const auto pose = decode_cdr<RosOdometry>(message->data);
            played.truth[pose.value().header.stamp.ns] = to_pose2(to_isometry(pose->pose));
            continue;
        } else if (topic == "/tf_static") {
            played.mounting = decode_cdr<RosTFMessage>(message->data);
            continue;
        } else {
            continue;
        }
        played.steps.push_back(std::move(step));
    }
    std::ranges::stable_sort(played.steps, {}, &Step::due_ns);
    const Pose2 start = played.truth.empty() ? Pose2{} : played.truth.begin()->second;
    for (auto& [stamp_ns, pose] : played.truth) {
        pose = between(start, pose);
    }
    if (const Fault* const carried = request.fault("carry")) {
        carry(played, carried->numbers.at(0), carried->numbers.at(1));
    }
    const std::int64_t end_ns = played.steps.front().stamp_ns + static_cast<std::int64_t>(1e9 * request.seconds);
    std::erase_if(played.steps, [&](const Step& step) { return step.stamp_ns > end_ns; });
    return played;
}

void set_time(builtin_interfaces_msg_dds__Time_& time, std::int64_t ns) {
    time.sec = static_cast<std::int32_t>(ns / 1'000'000'000);
    time.nanosec = static_cast<std::uint32_t>(ns % 1'000'000'000);
}

std::int64_t time_of(const builtin_interfaces_msg_dds__Time_& time) {
    return std::int64_t{time.sec} * 1'000'000'000 + time.nanosec;
}

void set_pose(geometry_msgs_msg_dds__Pose_& target, const RosPose& pose) {
    target = {{pose.position.x, pose.position.y, pose.position.z},
              {pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w}};
}

/// The robot's programs.
class Robot {
public:
    explicit Robot(const CycloneParticipant& participant)
        : scan_(participant, sensor_msgs_msg_dds__LaserScan__desc, "rt/scan", {.reliable = false, .depth = 5}),
          odom_(participant, nav_msgs_msg_dds__Odometry__desc, "rt/odom", {}),
          tf_(participant, tf2_msgs_msg_dds__TFMessage__desc, "rt/tf", {.depth = 100}),
          tf_static_(participant, tf2_msgs_msg_dds__TFMessage__desc, "rt/tf_static", {.is_kept_for_late = true}),
          clock_(participant, rosgraph_msgs_msg_dds__Clock__desc, "rt/clock", {.reliable = false, .depth = 1}),
          initial_(participant, geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, "rt/initialpose", {}) {}

    [[nodiscard]] bool is_heard() const {
        return scan_.readers() > 0 && odom_.readers() > 0 && tf_.readers() > 0 && initial_.readers() > 0;
    }
    void tell_clock(std::int64_t now_ns) {
        rosgraph_msgs_msg_dds__Clock_ message{};
        set_time(message.clock, now_ns);
        clock_.write(message);
    }
    void tell_mounting(RosTFMessage mounting) {
        for (RosTransformStamped& each : mounting.transforms) {
            write_transform(tf_static_, each, each.header.stamp.ns);
        }
    }
    void tell_pose(double x, double y) {
        geometry_msgs_msg_dds__PoseWithCovarianceStamped_ message{};
        std::string frame = "map";
        message.header.frame_id = frame.data();
        message.pose.position = {x, y, 0.0};
        message.pose.orientation = {0.0, 0.0, 0.0, 1.0};
        initial_.write(message);
    }
    void write(RosLaserScan scan, std::int64_t stamp_ns) {
        sensor_msgs_msg_dds__LaserScan_ message{};
        set_time(message.header.stamp, stamp_ns);
        message.header.frame_id = scan.header.frame_id.data();
        message.angle_min = scan.angle_min;
        message.angle_max = scan.angle_max;
        message.angle_increment = scan.angle_increment;
        message.time_increment = scan.time_increment;
        message.scan_time = scan.scan_time;
        message.range_min = scan.range_min;
        message.range_max = scan.range_max;
        message.ranges._length = message.ranges._maximum = static_cast<std::uint32_t>(scan.ranges.size());
        message.ranges._buffer = scan.ranges.data();
        scan_.write(message);
    }
    void write(RosOdometry odometry, std::int64_t stamp_ns) {
        nav_msgs_msg_dds__Odometry_ message{};
        set_time(message.header.stamp, stamp_ns);
        message.header.frame_id = odometry.header.frame_id.data();
        message.child_frame_id = odometry.child_frame_id.data();
        set_pose(message.pose, odometry.pose);
        odom_.write(message);
        RosTransformStamped transform{odometry.header, odometry.child_frame_id, odometry.pose};
        write_transform(tf_, transform, stamp_ns);
    }

private:
    static void write_transform(CycloneWriter<tf2_msgs_msg_dds__TFMessage_>& writer, RosTransformStamped& transform,
                                std::int64_t stamp_ns) {
        geometry_msgs_msg_dds__TransformStamped_ each{};
        set_time(each.header.stamp, stamp_ns);
        each.header.frame_id = transform.header.frame_id.data();
        each.child_frame_id = transform.child_frame_id.data();
        set_pose(each.transform, transform.transform);
        tf2_msgs_msg_dds__TFMessage_ message{};
        message.transforms._length = message.transforms._maximum = 1;
        message.transforms._buffer = &each;
        writer.write(message);
    }

    CycloneWriter<sensor_msgs_msg_dds__LaserScan_> scan_;
    CycloneWriter<nav_msgs_msg_dds__Odometry_> odom_;
    CycloneWriter<tf2_msgs_msg_dds__TFMessage_> tf_;
    CycloneWriter<tf2_msgs_msg_dds__TFMessage_> tf_static_;
    CycloneWriter<rosgraph_msgs_msg_dds__Clock_> clock_;
    CycloneWriter<geometry_msgs_msg_dds__PoseWithCovarianceStamped_> initial_;
};

struct MapSeen {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t occupied = 0;
};

void note(MapSeen& seen, const nav_msgs_msg_dds__OccupancyGrid_& map) {
    seen = {map.width, map.height,
            static_cast<std::size_t>(std::count_if(map.data._buffer, map.data._buffer + map.data._length,
                                                   [](std::uint8_t cell) { return cell == 100; }))};
}

Json json_of(const MapSeen& map) { return {{"width", map.width}, {"height", map.height}, {"occupied", map.occupied}}; }

/// Another program of the robot, such as its navigation, which hears what ddtool publishes.
class Listener {
public:
    explicit Listener(const CycloneParticipant& participant)
        : map_(participant, nav_msgs_msg_dds__OccupancyGrid__desc, "rt/map", latest),
          tf_(participant, tf2_msgs_msg_dds__TFMessage__desc, "rt/tf", {.depth = 1000}),
          pose_(participant, geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, "rt/pose", {}),
          cloud_(participant, geometry_msgs_msg_dds__PoseArray__desc, "rt/particlecloud", {}),
          degeneracy_(participant, ddtool_msgs_msg_dds__Degeneracy__desc, "rt/degeneracy", {}),
          diagnostics_(participant, diagnostic_msgs_msg_dds__DiagnosticArray__desc, "rt/diagnostics", {}) {}

    static constexpr CycloneQos latest{.reliable = true, .is_kept_for_late = true, .depth = 1};

    void sent_scan(std::int64_t stamp_ns) {
        const auto now = Clock::now();
        first_sent_ = first_sent_ == Clock::time_point{} ? now : first_sent_;
        sent_.emplace_back(stamp_ns, now);
    }

    void look(Clock::time_point now) {
        tf_.take([&](const tf2_msgs_msg_dds__TFMessage_& message) {
            for (std::uint32_t index = 0; index < message.transforms._length; ++index) {
                const auto& each = message.transforms._buffer[index];
                if (std::string(each.child_frame_id) == "odom" && std::string(each.header.frame_id) == "map") {
                    hear_transform(each, now);
                }
            }
        });
        map_.take([&](const nav_msgs_msg_dds__OccupancyGrid_& message) {
            ++maps_;
            note(seen_, message);
        });
        pose_.take([&](const auto& message) {
            ++poses_;
            stamp_ns_ = time_of(message.header.stamp);
            x_m_ = message.pose.position.x;
            y_m_ = message.pose.position.y;
            has_covariance_ = has_covariance_ || message.covariance[0] > 0.0;
        });
        cloud_.take([&](const auto& message) { particles_ = message.poses._length; });
        degeneracy_.take([&](const auto& /*message*/) { ++degrees_; });
        diagnostics_.take([&](const diagnostic_msgs_msg_dds__DiagnosticArray_& message) {
            if (message.status._length > 0) {
                const auto& status = message.status._buffer[0];
                diagnostics_said_[status.message] += 1;
                for (std::uint32_t index = 0; index < status.values._length; ++index) {
                    values_[status.values._buffer[index].key] = status.values._buffer[index].value;
                }
            }
        });
    }

    /// The stamp of the latest pose.
    [[nodiscard]] std::int64_t pose_stamp_ns() const { return stamp_ns_; }

    [[nodiscard]] Json report() const {
        std::vector<double> latencies = latencies_s_;
        std::ranges::sort(latencies);
        const auto quantile_ms = [&](double share) {
            const auto place = static_cast<std::size_t>(share * static_cast<double>(latencies.size()));
            return latencies.empty() ? Json() : Json(1e3 * latencies[std::min(place, latencies.size() - 1)]);
        };
        return {
            {"maps", maps_},
            {"map", json_of(seen_)},
            {"transforms", transforms_},
            {"longest_without_transform_s", longest_gap_s_},
            {"scans_answered", answered_},
            {"latency_ms", {{"median", quantile_ms(0.5)}, {"p99", quantile_ms(0.99)}, {"largest", quantile_ms(1.0)}}},
            {"poses", poses_},
            {"pose", {x_m_, y_m_}},
            {"has_covariance", has_covariance_},
            {"particles", particles_},
            {"degrees", degrees_},
            {"diagnostics", diagnostics_said_},
            {"values", values_}};
    }

private:
    /// The answer to a scan has the stamp of the scan and the tolerance.
    void hear_transform(const geometry_msgs_msg_dds__TransformStamped_& transform, Clock::time_point now) {
        ++transforms_;
        if (heard_) {
            longest_gap_s_ = std::max(longest_gap_s_, std::chrono::duration<double>(now - *heard_).count());
        }
        heard_ = now;
        const std::int64_t scan_ns = time_of(transform.header.stamp) - static_cast<std::int64_t>(1e9 * tolerance_s);
        const auto answered = std::ranges::find(sent_, scan_ns, [](const auto& scan) { return scan.first; });
        if (answered != sent_.end()) {
            ++answered_;
            if (answered->second - first_sent_ > while_surveyed) {
                latencies_s_.push_back(std::chrono::duration<double>(now - answered->second).count());
            }
            sent_.erase(sent_.begin(), answered + 1);
        }
    }

    CycloneReader<nav_msgs_msg_dds__OccupancyGrid_> map_;
    CycloneReader<tf2_msgs_msg_dds__TFMessage_> tf_;
    CycloneReader<geometry_msgs_msg_dds__PoseWithCovarianceStamped_> pose_;
    CycloneReader<geometry_msgs_msg_dds__PoseArray_> cloud_;
    CycloneReader<ddtool_msgs_msg_dds__Degeneracy_> degeneracy_;
    CycloneReader<diagnostic_msgs_msg_dds__DiagnosticArray_> diagnostics_;
    std::deque<std::pair<std::int64_t, Clock::time_point>> sent_;
    Clock::time_point first_sent_{};
    std::size_t answered_ = 0;
    std::vector<double> latencies_s_;
    std::optional<Clock::time_point> heard_;
    double longest_gap_s_ = 0.0;
    std::size_t maps_ = 0;
    MapSeen seen_;
    std::size_t transforms_ = 0;
    std::size_t poses_ = 0;
    std::int64_t stamp_ns_ = 0;
    double x_m_ = 0.0;
    double y_m_ = 0.0;
    bool has_covariance_ = false;
    std::size_t particles_ = 0;
    std::size_t degrees_ = 0;
    std::map<std::string, std::size_t> diagnostics_said_;
    std::map<std::string, std::string> values_;
};

/// Plays the steps, with the faults that are asked for.
class Play {
public:
    Play(const Request& request, Played played)
        : request_(request),
          played_(std::move(played)),
          participant_(request.domain),
          robot_(std::make_unique<Robot>(participant_)),
          listener_(participant_) {
        if (const Fault* const speed = request.fault("speed")) {
            speed_ = speed->numbers.at(0);
        }
    }

    Json run() {
        const double waited_s = meet();
        start_ = Clock::now();
        started_ns_ =
            std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
                .count();
        for (const Step& step : played_.steps) {
            play(step);
        }
        wait_until(Clock::now() + std::chrono::milliseconds(500));
        Json report = listener_.report();
        report["matched_after_s"] = waited_s;
        report["scans_sent"] = scans_;
        report["late_map"] = late_map();
        report["true_pose"] = true_pose();
        return report;
    }

private:
    double meet() {
        const auto start = Clock::now();
        const bool with_clock = request_.fault("clock") != nullptr;
        if (!holds_within(longest_matching, [&] {
                if (with_clock) {
                    robot_->tell_clock(played_.steps.front().stamp_ns);
                }
                return robot_->is_heard();
            })) {
            throw std::runtime_error("nobody hears the robot");
        }
        const double waited_s = std::chrono::duration<double>(Clock::now() - start).count();
        std::this_thread::sleep_for(until_both_know);
        if (played_.mounting) {
            robot_->tell_mounting(*played_.mounting);
        }
        return waited_s;
    }

    /// Where the robot was at the latest pose that it was told, from its place at the start.
    [[nodiscard]] Json true_pose() const {
        const std::int64_t since_ns = listener_.pose_stamp_ns() - stamp_of(played_.steps.front(), 0.0);
        const auto found = played_.truth.lower_bound(played_.steps.front().stamp_ns + since_ns);
        return found == played_.truth.end() ? Json() : Json{found->second.x_m, found->second.y_m};
    }

    [[nodiscard]] double time_s(std::int64_t log_ns) const {
        return 1e-9 * static_cast<double>(log_ns - played_.steps.front().stamp_ns);
    }

    [[nodiscard]] bool is_within(const std::string& name, double now_s) const {
        const Fault* const fault = request_.fault(name);
        return fault != nullptr && now_s >= fault->numbers.at(0) && now_s < fault->numbers.at(0) + fault->numbers.at(1);
    }

    void play(const Step& step) {
        const double now_s = time_s(step.due_ns());
        wait_until(start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(now_s / speed_)));
        if (is_within("pause", now_s)) {
            return;
        }
        if (is_within("mute", now_s) && step.odometry) {
            return;
        }
        if (const Fault* const restart = request_.fault("restart");
            restart != nullptr && !has_restarted_ && now_s >= restart->numbers.at(0)) {
            has_restarted_ = true;
            robot_.reset();
            robot_ = std::make_unique<Robot>(participant_);
            if (played_.mounting) {
                robot_->tell_mounting(*played_.mounting);
            }
        }
        if (const Fault* const pose = request_.fault("pose");
            pose != nullptr && !has_told_pose_ && now_s >= pose->numbers.at(0)) {
            has_told_pose_ = true;
            robot_->tell_pose(pose->numbers.at(1), pose->numbers.at(2));
        }
        const std::int64_t stamp_ns = stamp_of(step, now_s);
        if (request_.fault("clock") != nullptr) {
            robot_->tell_clock(step.due_ns());
        }
        if (step.scan) {
            listener_.sent_scan(stamp_ns);
            robot_->write(*step.scan, stamp_ns);
            ++scans_;
        } else {
            robot_->write(odometry_of(*step.odometry), stamp_ns);
        }
    }

    [[nodiscard]] std::int64_t stamp_of(const Step& step, double now_s) const {
        if (request_.fault("clock") != nullptr) {
            return step.stamp_ns;
        }
        const Fault* const jump = request_.fault("jump");
        const double by_s = jump != nullptr && now_s >= jump->numbers.at(0) ? jump->numbers.at(1) : 0.0;
        return started_ns_ + static_cast<std::int64_t>(1e9 * (time_s(step.stamp_ns) + by_s));
    }

    /// The odometry begins at zero again after a restart.
    RosOdometry odometry_of(RosOdometry odometry) {
        const Pose2 logged = to_pose2(to_isometry(odometry.pose));
        if (has_restarted_ && !restarted_at_) {
            restarted_at_ = logged;
        }
        if (restarted_at_) {
            odometry.pose = to_ros_pose(between(*restarted_at_, logged));
        }
        return odometry;
    }

    /// Listens until then.
    void wait_until(Clock::time_point end) {
        for (;;) {
            const auto now = Clock::now();
            listener_.look(now);
            if (now >= end) {
                return;
            }
            std::this_thread::sleep_until(std::min(end, now + std::chrono::microseconds(200)));
        }
    }

    /// The map that a program gets which starts only now.
    Json late_map() {
        CycloneReader<nav_msgs_msg_dds__OccupancyGrid_> reader(participant_, nav_msgs_msg_dds__OccupancyGrid__desc,
                                                               "rt/map", Listener::latest);
        MapSeen seen;
        holds_within(std::chrono::seconds(5), [&] {
            reader.take([&](const nav_msgs_msg_dds__OccupancyGrid_& message) { note(seen, message); });
            return seen.width > 0;
        });
        return json_of(seen);
    }

    const Request& request_;
    Played played_;
    CycloneParticipant participant_;
    std::unique_ptr<Robot> robot_;
    Listener listener_;
    double speed_ = 1.0;
    Clock::time_point start_;
    std::int64_t started_ns_ = 0;
    std::size_t scans_ = 0;
    bool has_restarted_ = false;
    bool has_told_pose_ = false;
    std::optional<Pose2> restarted_at_;
};

}  // namespace
}  // namespace ddtool::test

int main(int argc, char** argv) {
    try {
        const auto request = ddtool::test::request_of(argc, argv);
        std::cout << ddtool::test::Play(request, ddtool::test::read_log(request)).run().dump(1) << "\n";
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "cyclone_robot: " << error.what() << "\n";
        return 1;
    }
}
