#include "ros/ros_link.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <numbers>
#include <set>
#include <thread>
#include <utility>

#include "base/text.hpp"
#include "ddtool/base/error.hpp"
#include "localization/localizer.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/message_log_stream.hpp"
#include "logs/stream/topic_names.hpp"
#include "ros/dds_node.hpp"
#include "ros/latency_record.hpp"
#include "ros/raw_odometry.hpp"
#include "ros/robot_clock.hpp"
#include "ros/robot_messages.hpp"
#include "ros/ros_arguments.hpp"
#include "ros/silence_watch.hpp"
#include "ros/stamp_bytes.hpp"
#include "ros/stamp_watch.hpp"
#include "run/live_run.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

using namespace std::chrono_literals;

constexpr const char* map_frame = "map";
constexpr const char* transforms_topic = "/tf";
constexpr const char* static_transforms_topic = "/tf_static";

/// The transform map -> odom is sent again after this time without a new one, so that it never runs out while the
/// filter is busy.
constexpr auto transform_interval = 50ms;
constexpr auto diagnostics_interval = 1s;
constexpr auto waiting_note_interval = 5s;
/// Longer than a survey takes for which nothing is missing.
constexpr std::int64_t longest_survey_ns = 15'000'000'000;
/// From a degree of one half on a scan counts as degenerate.
constexpr double degenerate_degree = 0.5;

// As ROS 2's own nodes have it. Sensors are heard best effort, because a reader that wants more hears no writer that
// offers less; a message that is lost is followed by the next one soon.
constexpr TopicQos sensor_qos{.reliable = false, .is_kept_for_late = false, .depth = 5};
constexpr TopicQos motion_qos{.reliable = false, .is_kept_for_late = false, .depth = 100};
constexpr TopicQos transform_qos{.reliable = true, .is_kept_for_late = false, .depth = 100};
constexpr TopicQos static_qos{.reliable = true, .is_kept_for_late = true, .depth = 100};
constexpr TopicQos clock_qos{.reliable = false, .is_kept_for_late = false, .depth = 1};
constexpr TopicQos event_qos{.reliable = true, .is_kept_for_late = false, .depth = 10};
constexpr TopicQos latest_qos{.reliable = true, .is_kept_for_late = true, .depth = 1};

std::int64_t steady_now_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
std::int64_t system_now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// The deviations of a pose that somebody told, from its covariance: at least what a hand on a screen can tell, and
/// where the message says nothing, the usual ones.
localization::StartPose start_pose_of(const Pose2& map_from_robot, const std::array<double, 36>& covariance) {
    constexpr double least_sd_m = 0.1;
    constexpr double least_sd_rad = 0.05;
    constexpr std::size_t x = 0;
    constexpr std::size_t y = 7;
    constexpr std::size_t yaw = 35;
    localization::StartPose start{.pose = map_from_robot};
    if (const double variance = std::max(covariance[x], covariance[y]); variance > 0.0 && std::isfinite(variance)) {
        start.sd_m = std::max(least_sd_m, std::sqrt(variance));
    }
    if (const double variance = covariance[yaw]; variance > 0.0 && std::isfinite(variance)) {
        start.sd_rad = std::clamp(std::sqrt(variance), least_sd_rad, std::numbers::pi);
    }
    return start;
}

/// Publishes what the filter makes. Its stamps are those that the filter got, in which jumps of the robot's clock are
/// taken out; they are put back.
class RobotTopics : public Ros2Sink {
public:
    RobotTopics(DdsNode& node, const RosArguments& arguments) : node_(node), arguments_(arguments) {}

    /// What has been added to the stamps that the filter gets.
    void set_offset(std::int64_t offset_ns) { offset_ns_ = offset_ns; }
    /// A pose that others must not rely on is not published.
    void set_pose_is_known(bool is_known) { pose_is_known_ = is_known; }

protected:
    void put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
             std::span<const std::byte> data) override {
        if (topic == "/pose" && !pose_is_known_) {
            return;
        }
        message_.assign(data.begin(), data.end());
        if (offset_ns_ != 0) {
            set_first_stamp(message_, stamp_ns - offset_ns_);
        }
        const bool is_latest = topic == "/map" || topic == "/path";
        // Names are relative to the node's namespace, as those of ROS 2's own mapping nodes are.
        node_.write(resolved_topic(arguments_, topic.substr(1)), type_name, is_latest ? latest_qos : event_qos,
                    message_);
    }

private:
    DdsNode& node_;
    const RosArguments& arguments_;
    std::int64_t offset_ns_ = 0;
    bool pose_is_known_ = true;
    std::vector<std::byte> message_;
};

/// The latest transforms between the map and the robot, which are sent again and again.
struct SentTransforms {
    RosTFMessage message;  ///< stamped anew each time it is sent
    std::chrono::steady_clock::time_point sent;
};

/// What the diagnostics tell; written by the filter's thread, read by that of the timer.
struct Progress {
    std::size_t frames = 0;
    std::size_t updates = 0;
    double degree = 0.0;
    double latency_median_s = 0.0;
    double latency_high_s = 0.0;
    std::optional<localization::Standing> standing;  ///< of a robot in a map of before
    std::size_t withdrawals = 0;                     ///< how often map -> odom was sent no more
};

class RosLink : public RobotLink {
public:
    explicit RosLink(RosArguments arguments)
        : arguments_(std::move(arguments)),
          environment_(ros_environment([](const char* name) { return std::getenv(name); })),
          clock_(arguments_.use_sim_time),
          stamps_(arguments_.use_sim_time),
          messages_([this](const McapChannel& channel, RobotMessages::Arrived& message) { prepare(channel, message); }),
          node_(environment_, arguments_.node, arguments_.name_space),
          topics_(node_, arguments_),
          live_(topics_, RunMessages::Reader::robot) {
        if (arguments_.use_sim_time) {
            node_.subscribe("/clock", RosClock::type_name, clock_qos, [this](std::span<const std::byte> data) {
                if (const auto time_ns = first_stamp_ns(data)) {
                    clock_.told(*time_ns);
                }
            });
        }
        const std::string initial_pose = resolved_topic(arguments_, "initialpose");
        node_.subscribe(initial_pose, RosPoseWithCovarianceStamped::type_name, event_qos,
                        [this, initial_pose](std::span<const std::byte> data) { hear_pose(initial_pose, data); });
        timer_ = std::jthread([this](const std::stop_token& stop) { run_timer(stop); });
    }

    ~RosLink() override = default;

    [[nodiscard]] std::string name() const override { return "ros"; }

    std::unique_ptr<LogStream> scans(const LogOptions& options, std::function<bool()> stop,
                                     LogProblemHandler on_problem) override {
        const LogOptions resolved = subscribe(options);
        wait_for_scans(stop);
        surveyed_since_ns_ = steady_now_ns();
        const auto open = [&](const LogProblemHandler& /*on_problem*/) {
            return std::make_unique<Source>(messages_, stop);
        };
        auto stream = std::make_unique<MessageLogStream>(open, MessageLogStream::Opening::live, "ROS 2", name(),
                                                         resolved, std::move(on_problem));
        surveyed_since_ns_ = 0;
        stream_ = stream.get();
        arrivals_.clear();  // scans that came during the survey are late
        return stream;
    }

    void show_fixed_map(const MapRaster& map) override {
        map_is_fixed_ = true;
        live_.show_fixed_map(clock_now_ns(), map);
    }

    std::optional<localization::StartPose> take_initial_pose() override {
        const std::lock_guard lock(mutex_);
        return std::exchange(initial_pose_, std::nullopt);
    }

    void add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter,
             const localization::Standing* standing) override {
        const bool is_found = note_place(standing);
        send_transforms(frame, is_found ? std::optional(filter.pose()) : std::nullopt);
        note_latency(frame.scan.stamp_ns);
        {
            const std::lock_guard lock(mutex_);
            ++progress_.frames;
            progress_.updates += update ? 1 : 0;
            progress_.degree = update ? update->degeneracy.degree : progress_.degree;
        }
        topics_.set_offset(stamps_.offset_of(first_scan_topic_));
        topics_.set_pose_is_known(is_found);
        live_.add(frame, update, filter);
    }

    void finish(const MapRaster& map, const Trajectory& path) override {
        live_.finish(map, path);
        if (const std::size_t passed = messages_.passed_over(); passed > 0) {
            log_info(std::to_string(passed) + " of " + std::to_string(messages_.scans()) +
                     " scans were passed over, because a newer one came while the filter was busy");
        }
    }

    [[nodiscard]] Json report() const override {
        const std::lock_guard lock(mutex_);
        return {
            {"domain", environment_.domain},
            {"loopback_only", environment_.loopback_only},
            {"node", arguments_.node},
            {"namespace", arguments_.name_space},
            {"use_sim_time", arguments_.use_sim_time},
            {"transform_tolerance_s", arguments_.transform_tolerance_s},
            {"scans_received", messages_.scans()},
            {"scans_passed_over", messages_.passed_over()},
            {"silences", silence_.silences()},
            {"clock_jumps", clock_jumps_},
            {"transform_withdrawals", progress_.withdrawals},
            {"latency_s",
             {{"median", latency_.quantile_s(0.5)}, {"p99", latency_.quantile_s(0.99)}, {"scans", latency_.count()}}}};
    }

    [[nodiscard]] std::vector<std::string> losses() const override {
        const std::size_t passed = messages_.passed_over();
        const std::size_t scans = messages_.scans();
        if (2 * passed <= scans) {
            return {};
        }
        return {name() + ": " + std::to_string(passed) + " of " + std::to_string(scans) +
                " scans were passed over because they came faster than they were worked off; with fewer --particles "
                "each takes less time"};
    }

private:
    /// Gives the messages to one stream, and stops when that is asked to.
    class Source : public MessageSource {
    public:
        Source(RobotMessages& messages, std::function<bool()> stop) : messages_(messages), stop_(std::move(stop)) {}
        std::optional<McapMessage> next() override { return messages_.next(stop_); }
        [[nodiscard]] double fraction_read() const override { return 0.0; }

    private:
        RobotMessages& messages_;
        std::function<bool()> stop_;
    };

    /// Subscribes to the topics that the options name, and to those that every robot has. Returns the options with the
    /// names as the robot has them.
    LogOptions subscribe(LogOptions options) {
        const auto named = [&](std::string& option, const char* usual) {
            std::vector<std::string> names = topics_named(option);
            if (names.empty() && usual != nullptr) {
                names.emplace_back(usual);
            }
            option.clear();
            for (std::string& each : names) {
                each = resolved_topic(arguments_, each);
                option += (option.empty() ? "" : ",") + each;
            }
            return names;
        };
        const auto scans = named(options.scan_topic, options.cloud_topic.empty() ? "scan" : nullptr);
        const auto clouds = named(options.cloud_topic, nullptr);
        first_scan_topic_ = scans.empty() ? clouds.front() : scans.front();
        for (const std::string& topic : scans) {
            hear(topic, RosLaserScan::type_name, sensor_qos, RobotMessages::Kind::scan);
        }
        for (const std::string& topic : clouds) {
            hear(topic, RosPointCloud2::type_name, sensor_qos, RobotMessages::Kind::scan);
        }
        const std::string transforms = resolved_topic(arguments_, transforms_topic);
        hear(transforms, RosTFMessage::type_name, transform_qos, RobotMessages::Kind::other);
        hear(resolved_topic(arguments_, static_transforms_topic), RosTFMessage::type_name, static_qos,
             RobotMessages::Kind::other);
        if (options.with_odometry) {
            const bool is_named = !options.odom_topic.empty();
            for (const std::string& topic : named(options.odom_topic, "odom")) {
                if (topic != transforms) {
                    hear(topic, RosOdometry::type_name, motion_qos, RobotMessages::Kind::other);
                }
            }
            options.odom_topic = is_named ? options.odom_topic : "";  // or it comes from the transforms
        }
        if (options.imu_topic != "none") {
            const bool is_named = !options.imu_topic.empty();
            for (const std::string& topic : named(options.imu_topic, "imu")) {
                hear(topic, RosImu::type_name, motion_qos, RobotMessages::Kind::other);
            }
            options.imu_topic = is_named ? options.imu_topic : "";  // or there is none
        }
        for (const std::string& topic : named(options.ground_truth_topic, nullptr)) {
            hear(topic, RosOdometry::type_name, motion_qos, RobotMessages::Kind::other);
        }
        return options;
    }

    void hear(const std::string& topic, const char* type_name, const TopicQos& qos, RobotMessages::Kind kind) {
        if (!heard_.insert(topic).second) {
            return;  // an option names a topic that is heard for another reason
        }
        const std::size_t channel = messages_.add_topic(topic, type_name, kind);
        const bool tells_time = topic == first_scan_topic_;  // one alone, since their clocks may differ
        const bool goes_on = !qos.is_kept_for_late;          // static transforms are told once
        const std::size_t watched = goes_on ? silence_.add_topic(topic) : 0;
        node_.subscribe(topic, type_name, qos, [=, this](std::span<const std::byte> data) {
            const std::int64_t now_ns = steady_now_ns();
            const auto stamp_ns = tells_time ? first_stamp_ns(data) : std::nullopt;
            if (stamp_ns && *stamp_ns != 0) {
                clock_.heard(*stamp_ns, now_ns);
            }
            if (goes_on) {
                silence_.heard(watched, now_ns);
            }
            messages_.push(channel, data, now_ns, arguments_.use_sim_time ? clock_.now_ns(now_ns) : system_now_ns());
        });
    }

    /// Says every few seconds what is missing.
    void wait_for_scans(const std::function<bool()>& stop) {
        auto note_due = std::chrono::steady_clock::now() + waiting_note_interval;
        log_info("waiting for scans on " + first_scan_topic_ + " (ROS 2, domain " +
                 std::to_string(environment_.domain) + (environment_.loopback_only ? ", this machine alone)" : ")"));
        while (messages_.scans() == 0 || (arguments_.use_sim_time && !clock_.is_told())) {
            if (stop()) {
                throw Error("interrupted before the first scan on " + first_scan_topic_ + " came; nothing is written");
            }
            if (const auto now = std::chrono::steady_clock::now(); now > note_due) {
                note_due = now + waiting_note_interval;
                const std::string topic = messages_.scans() == 0 ? first_scan_topic_ : "/clock";
                const std::size_t writers = node_.writers_of(topic);
                log_info("still waiting for " + topic + ": " +
                         (writers == 0 ? "nobody publishes it (is ROS_DOMAIN_ID the same, and ROS_LOCALHOST_ONLY?)"
                                       : std::to_string(writers) + " publish it, and nothing has come"));
            }
            std::this_thread::sleep_for(20ms);
        }
    }

    void hear_pose(const std::string& topic, std::span<const std::byte> data) {
        const auto message = decode_cdr<RosPoseWithCovarianceStamped>(data);
        const Eigen::Isometry3d pose = message ? to_isometry(message->pose) : Eigen::Isometry3d::Identity();
        if (!message || !pose.matrix().allFinite() || pose.translation().norm() > farthest_m) {
            log_warning(topic + ": a pose that is no number is not used");
            return;
        }
        const std::string& frame = message->header.frame_id;
        if (!frame.empty() && frame != map_frame && frame != std::string("/") + map_frame) {
            log_warning(topic + ": a pose in the frame '" + frame + "' is not used; expected one in the frame map");
            return;
        }
        const Pose2 map_from_robot = to_pose2(pose);
        log_info(topic + ": the robot is taken to be at " + fixed_text(map_from_robot.x_m, 2) + ", " +
                 fixed_text(map_from_robot.y_m, 2) + " m, " + fixed_text(map_from_robot.theta_rad, 2) + " rad");
        const std::lock_guard lock(mutex_);
        initial_pose_ = start_pose_of(map_from_robot, message->covariance);
    }

    /// Takes jumps of the clock out of the stamps. Runs on the filter's thread, before a message is given to it.
    void prepare(const McapChannel& channel, RobotMessages::Arrived& message) {
        if (channel.schema.name == RosTFMessage::type_name) {
            prepare_transforms(channel, message);
        } else if (const auto stamp_ns = first_stamp_ns(message.data); stamp_ns && *stamp_ns != 0) {
            if (const std::int64_t offset_ns = offset_of(channel.topic, *stamp_ns, message.arrived_ns)) {
                set_first_stamp(message.data, *stamp_ns + offset_ns);
            }
            if (channel.topic == first_scan_topic_) {
                note_arrival(*stamp_ns + stamps_.offset_of(channel.topic), message.arrived_ns);
            }
        }
        McapMessage prepared;
        prepared.channel = &channel;
        prepared.log_time_ns = message.log_time_ns;
        prepared.data = message.data;
        odometry_.add(prepared);
    }

    void prepare_transforms(const McapChannel& channel, RobotMessages::Arrived& message) {
        auto transforms = decode_cdr<RosTFMessage>(message.data);
        if (!transforms || transform_names_static(channel.topic)) {
            return;
        }
        bool is_changed = false;
        for (RosTransformStamped& each : transforms->transforms) {
            std::int64_t& stamp_ns = each.header.stamp.ns;
            // Transforms of one topic come from several programs, some of which stamp them ahead.
            const std::int64_t offset_ns =
                stamp_ns == 0 ? 0 : offset_of(channel.topic + " " + each.child_frame_id, stamp_ns, message.arrived_ns);
            stamp_ns += offset_ns;
            is_changed = is_changed || offset_ns != 0;
        }
        if (is_changed) {
            message.data = encode_cdr(*transforms);
        }
    }

    static bool transform_names_static(const std::string& topic) { return topic.ends_with(static_transforms_topic); }

    std::int64_t offset_of(const std::string& source, std::int64_t stamp_ns, std::int64_t arrived_ns) {
        const std::int64_t offset_ns = stamps_.offset_ns(source, stamp_ns, arrived_ns);
        if (const auto& jump = stamps_.new_jump()) {
            log_warning(jump->source + ": the clock of its stamps jumped by " + fixed_text(jump->by_s, 2) +
                        " s; the run goes on as if it had not");
            const std::lock_guard lock(mutex_);
            ++clock_jumps_;
        }
        return offset_ns;
    }

    void note_arrival(std::int64_t stamp_ns, std::int64_t arrived_ns) {
        arrivals_.emplace_back(stamp_ns, arrived_ns);
        if (arrivals_.size() > MessageLogStream::max_waiting) {
            arrivals_.pop_front();
        }
    }

    /// From the arrival of the scan to the moment when map -> odom has been sent for it.
    void note_latency(std::int64_t stamp_ns) {
        const auto found = std::ranges::find(arrivals_, stamp_ns, [](const auto& arrival) { return arrival.first; });
        if (found == arrivals_.end()) {
            return;
        }
        latency_.add(1e-9 * static_cast<double>(steady_now_ns() - found->second));
        arrivals_.erase(arrivals_.begin(), found + 1);
        const std::lock_guard lock(mutex_);
        progress_.latency_median_s = latency_.quantile_s(0.5);
        progress_.latency_high_s = latency_.quantile_s(0.99);
    }

    /// Notes what is known about being in the right place, and says when that changes. Returns whether others may rely
    /// on the pose.
    bool note_place(const localization::Standing* standing) {
        if (standing == nullptr) {
            return true;
        }
        using localization::PlaceState;
        const std::lock_guard lock(mutex_);
        const PlaceState before = progress_.standing ? progress_.standing->place : PlaceState::searching;
        progress_.standing = *standing;
        const bool is_found = standing->place == PlaceState::found;
        if (is_found && before != PlaceState::found) {
            log_info("the robot is found in the map: map -> odom is published from now on");
        } else if (!is_found && before == PlaceState::found) {
            ++progress_.withdrawals;
            log_warning(std::string(standing->place == PlaceState::lost
                                        ? "the robot is lost: its scans do not fit the map where it seemed to be"
                                        : "the robot may be at one of several places that fit alike") +
                        "; map -> odom is not published until it is found again");
        }
        return is_found;
    }

    /// Without map_from_robot, what connects the map with the robot is not sent, and not sent again.
    void send_transforms(const SensorFrame& frame, const std::optional<Pose2>& map_from_robot) {
        const LogSummary& log = stream_->summary();
        const std::optional<Pose2> raw = odometry_.at(frame.scan.stamp_ns, log);
        const Pose2 odom_from_robot = raw.value_or(frame.odom_from_robot);
        const std::string odom_frame = log.odom_frame.empty() ? "odom" : log.odom_frame;
        const std::int64_t stamp_ns = frame.scan.stamp_ns - stamps_.offset_of(first_scan_topic_) + tolerance_ns();
        RosTFMessage message;
        if (map_from_robot) {
            message = transform_message(stamp_ns, map_frame, odom_frame, *map_from_robot * inverse(odom_from_robot));
        }
        if (!raw) {
            // Nobody publishes an odometry, so that what was worked out from the scans stands for it.
            const std::string robot_frame = log.robot_frame.empty() ? "base_link" : log.robot_frame;
            message.transforms.push_back(
                transform_message(stamp_ns, odom_frame, robot_frame, odom_from_robot).transforms.front());
        }
        const std::lock_guard lock(mutex_);
        if (!message.transforms.empty()) {
            write_transforms(message);
        }
        sent_ = {std::move(message), std::chrono::steady_clock::now()};
    }

    void write_transforms(const RosTFMessage& message) {
        node_.write(resolved_topic(arguments_, transforms_topic), RosTFMessage::type_name, transform_qos,
                    encode_cdr(message));
    }

    [[nodiscard]] std::int64_t tolerance_ns() const {
        return static_cast<std::int64_t>(1e9 * arguments_.transform_tolerance_s);
    }

    /// What time it is, as nodes of ROS 2 take it.
    [[nodiscard]] std::int64_t clock_now_ns() const {
        return arguments_.use_sim_time ? clock_.now_ns(steady_now_ns()) : system_now_ns();
    }

    void run_timer(const std::stop_token& stop) {
        auto diagnostics_due = std::chrono::steady_clock::now() + diagnostics_interval;
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(transform_interval / 2);
            const auto now = std::chrono::steady_clock::now();
            continue_transforms(now);
            tell_silences();
            tell_what_is_missing();
            if (now >= diagnostics_due) {
                diagnostics_due = now + diagnostics_interval;
                tell_diagnostics();
            }
        }
    }

    void continue_transforms(std::chrono::steady_clock::time_point now) {
        const std::lock_guard lock(mutex_);
        if (sent_.message.transforms.empty() || now - sent_.sent < transform_interval) {
            return;
        }
        for (RosTransformStamped& each : sent_.message.transforms) {
            each.header.stamp.ns = clock_.now_ns(steady_now_ns()) + tolerance_ns();
        }
        write_transforms(sent_.message);
        sent_.sent = now;
    }

    void tell_silences() {
        while (const auto finding = silence_.look(steady_now_ns())) {
            if (finding->is_back) {
                log_info(finding->topic + ": is back after " + fixed_text(finding->silent_s, 1) + " s");
            } else {
                const std::size_t writers = node_.writers_of(finding->topic);
                log_warning(finding->topic + ": nothing has come for " + fixed_text(finding->silent_s, 1) + " s; " +
                            (writers == 0 ? "its publisher is gone" : "its publisher is there") +
                            "; the run goes on when it comes back");
            }
        }
    }

    /// A topic that an option names is waited for.
    void tell_what_is_missing() {
        const std::int64_t since_ns = surveyed_since_ns_;
        if (since_ns == 0 || steady_now_ns() - since_ns < longest_survey_ns) {
            return;
        }
        std::int64_t expected_ns = since_ns;
        if (surveyed_since_ns_.compare_exchange_strong(expected_ns, 0)) {  // said once
            log_info("still looking at what the robot publishes; nothing has come on " +
                     joined(silence_.never_heard()) + "; those that an option names are waited for");
        }
    }

    void tell_diagnostics() {
        RosDiagnosticStatus status;
        {
            const std::lock_guard lock(mutex_);
            const std::size_t passed = messages_.passed_over();
            status = judged(passed > told_passed_over_);
            told_passed_over_ = passed;
            const auto ms = [](double seconds) { return fixed_text(1e3 * seconds, 1); };
            status.values = {{"scans received", std::to_string(messages_.scans())},
                             {"scans passed over", std::to_string(passed)},
                             {"filter updates", std::to_string(progress_.updates)},
                             {"degree of degeneracy", fixed_text(progress_.degree, 3)},
                             {"latency median ms", ms(progress_.latency_median_s)},
                             {"latency p99 ms", ms(progress_.latency_high_s)},
                             {"clock jumps", std::to_string(clock_jumps_)}};
            if (const auto& standing = progress_.standing) {
                status.values.insert(
                    status.values.end(),
                    {{"probability of the pose", fixed_text(standing->probability, 3)},
                     {"probability of being lost", fixed_text(standing->lost, 3)},
                     {"weight of the pose's place", fixed_text(standing->mode_weight, 3)},
                     {"places that fit", std::to_string(standing->modes)},
                     {"share of the scan in the map", fixed_text(standing->support, 3)},
                     {"map -> odom", standing->place == localization::PlaceState::found ? "published" : "withheld"}});
            }
        }
        status.name = arguments_.node + (map_is_fixed_ ? ": localization" : ": slam");
        status.hardware_id = "none";
        node_.write("/diagnostics", RosDiagnosticArray::type_name, event_qos,
                    encode_cdr(RosDiagnosticArray{{{clock_now_ns()}, ""}, {status}}));
    }

    /// The level and the message of the diagnostics. The mutex must be held.
    [[nodiscard]] RosDiagnosticStatus judged(bool is_falling_behind) const {
        using localization::PlaceState;
        const auto as = [](std::uint8_t level, const char* message) {
            return RosDiagnosticStatus{.level = level, .name = "", .message = message, .hardware_id = "", .values = {}};
        };
        if (progress_.frames == 0) {
            return as(RosDiagnosticStatus::stale, "waiting for scans");
        }
        if (silence_.is_silent(0)) {
            return as(RosDiagnosticStatus::stale, "no scans come");
        }
        switch (progress_.standing ? progress_.standing->place : PlaceState::found) {
            case PlaceState::searching:
                return as(RosDiagnosticStatus::warning, "looking for the robot in the map");
            case PlaceState::ambiguous:
                return as(RosDiagnosticStatus::error, "several places fit alike");
            case PlaceState::lost:
                return as(RosDiagnosticStatus::error, "the robot is lost");
            case PlaceState::found:
                break;
        }
        if (progress_.degree >= degenerate_degree) {
            return as(RosDiagnosticStatus::warning, "the scans do not determine the pose");
        }
        if (is_falling_behind) {
            return as(RosDiagnosticStatus::warning, "scans are passed over");
        }
        return as(RosDiagnosticStatus::ok, map_is_fixed_ ? "localising" : "mapping");
    }

    RosArguments arguments_;
    RosEnvironment environment_;
    RobotClock clock_;
    SilenceWatch silence_;
    std::atomic<std::int64_t> surveyed_since_ns_ = 0;  ///< 0: the survey is over, or what it lacks has been said
    std::atomic<bool> map_is_fixed_ = false;
    std::string first_scan_topic_;
    std::set<std::string> heard_;  ///< the topics that are subscribed to for the filter

    // Used by the filter's thread alone.
    StampWatch stamps_;
    RawOdometry odometry_;
    LatencyRecord latency_;
    std::deque<std::pair<std::int64_t, std::int64_t>> arrivals_;  ///< stamp and arrival of the latest scans
    const LogStream* stream_ = nullptr;

    mutable std::mutex mutex_;  ///< of what follows, up to the messages
    std::optional<localization::StartPose> initial_pose_;
    SentTransforms sent_;
    Progress progress_;
    std::size_t told_passed_over_ = 0;
    std::size_t clock_jumps_ = 0;

    RobotMessages messages_;
    DdsNode node_;  ///< declared after all that its threads use
    RobotTopics topics_;
    LiveRun live_;
    std::jthread timer_;  ///< declared last, so that it ends first
};

}  // namespace

std::unique_ptr<RobotLink> join_ros(const std::vector<std::string>& ros_arguments) {
    return std::make_unique<RosLink>(parse_ros_arguments(ros_arguments));
}

}  // namespace ddtool
