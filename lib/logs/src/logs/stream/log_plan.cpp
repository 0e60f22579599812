#include "logs/stream/log_plan.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "logs/stream/cloud_scan.hpp"
#include "logs/stream/idle_options.hpp"
#include "logs/stream/topic_names.hpp"

namespace ddtool {
namespace {

using Topics = std::vector<TopicSurvey>;

/// Between what was measured and what was recorded there is always some delay, of the lidar's turn and more.
constexpr double least_clock_offset_s = 0.5;
/// The cosine of 30 degrees. A robot stands more level than that.
constexpr double least_agreement = 0.866;

template <typename Condition>
Topics topics_where(const LogSurvey& survey, Condition condition) {
    Topics chosen;
    std::copy_if(survey.topics.begin(), survey.topics.end(), std::back_inserter(chosen), condition);
    return chosen;
}

std::string names_of(const Topics& topics) {
    std::string names;
    for (const TopicSurvey& topic : topics) {
        names += (names.empty() ? "" : ", ") + topic.topic;
    }
    return names.empty() ? "none" : names;
}

std::string joined_by_commas(std::string text, const std::vector<std::string>& more) {
    for (const std::string& word : more) {
        text += "," + word;
    }
    return text;
}

const TopicSurvey& find_requested(const Topics& topics, const std::string& name, const std::string& what,
                                  const std::string& file) {
    const auto found =
        std::find_if(topics.begin(), topics.end(), [&](const TopicSurvey& topic) { return topic.topic == name; });
    if (found == topics.end()) {
        throw UsageError(file + ": has no " + what + " topic '" + name +
                         "'; of that type there is: " + names_of(topics));
    }
    return *found;
}

/// Builds the plan from a survey, part by part.
class Planner {
public:
    Planner(const LogSurvey& survey, const LogOptions& options, const std::string& file)
        : survey_(survey), options_(options), file_(file) {}

    LogPlan plan() {
        choose_scans();
        find_robot();
        choose_ground_truth();
        choose_odometry();
        find_mountings();
        find_heights();
        find_echo();
        find_no_returns();
        judge_units();
        find_sweep();
        choose_imu();
        note_options_without_effect();
        plan_.has_information = survey_.has_information;
        return plan_;
    }

private:
    void assume(const std::string& text) { plan_.assumptions.push_back(file_ + ": " + text); }
    void blame(const std::string& text) { plan_.faults.push_back(file_ + ": " + text); }

    /// Chooses the topic with the shortest name: /scan rather than /scan_filtered.
    const TopicSurvey& plainest(const Topics& topics, const std::string& what) {
        const auto shorter = [](const TopicSurvey& a, const TopicSurvey& b) { return a.topic.size() < b.topic.size(); };
        const TopicSurvey& chosen = *std::min_element(topics.begin(), topics.end(), shorter);
        if (topics.size() > 1) {
            assume("several " + what + " topics (" + names_of(topics) + "); using " + chosen.topic);
        }
        return chosen;
    }

    void choose_scans() {
        name_scans(MessageKind::scan, options_.scan_topic, "scan");
        name_scans(MessageKind::cloud, options_.cloud_topic, "point cloud");
        if (lidars_.empty()) {
            find_scans(of_kind(MessageKind::scan).empty() ? MessageKind::cloud : MessageKind::scan);
        }
        scan_ = lidars_.front();
        for (const TopicSurvey& lidar : lidars_) {
            expect_ranges(lidar);
            plan_.lidars.push_back({.topic = lidar.topic,
                                    .stamps = stamps_of(lidar.stamps, "the scans " + lidar.topic),
                                    .ranges = {},
                                    .sweep = {}});
        }
    }

    /// Takes the topics that an option names.
    void name_scans(MessageKind kind, const std::string& names, const std::string& what) {
        const Topics topics = of_robot(of_kind(kind));
        for (const std::string& name : topics_named(names)) {
            const TopicSurvey& topic = find_requested(topics, name, what, file_);
            if (std::ranges::count(lidars_, name, &TopicSurvey::topic) == 0) {
                lidars_.push_back(topic);
            }
        }
    }

    void find_scans(MessageKind kind) {
        const Topics all = of_kind(kind);
        Topics scans = of_robot(all);
        if (all.empty()) {
            fail_without_scans();
        }
        if (scans.empty()) {
            throw UsageError(file_ + ": has no scans of a robot '" + options_.robot + "'; its scan topics are " +
                             names_of(all));
        }
        if (std::ranges::any_of(scans, has_ranges)) {
            std::erase_if(scans, [](const TopicSurvey& topic) { return !has_ranges(topic); });
        }
        lidars_ = {plainest(scans, kind == MessageKind::cloud ? "point cloud" : "scan")};
    }

    /// The topics of scans of the robot that the options name, if they do.
    Topics of_robot(Topics scans) const {
        if (!options_.robot.empty()) {
            std::erase_if(scans, [&](const TopicSurvey& topic) { return !is_of_robot(topic, options_.robot); });
        }
        return scans;
    }

    Topics of_kind(MessageKind kind) const {
        return topics_where(survey_, [&](const TopicSurvey& topic) { return topic.kind == kind; });
    }

    /// How to read the stamps of a topic that is used; says what is wrong with them.
    StampRule stamps_of(const StampSurvey& stamps, const std::string& what) {
        StampRule rule = stamps.rule(what);
        if (!rule.assumption.empty()) {
            assume(rule.assumption);
        }
        if (!rule.fault.empty()) {
            blame(rule.fault);
        }
        return rule;
    }

    static ClockLag clock_by(const StampRule& rule, const ClockLag& clock, const StampSurvey& stamps) {
        return rule.from_recording ? ClockLag::of_recording(stamps.first_recorded_ns(), stamps.last_recorded_ns())
                                   : clock;
    }

    static bool has_ranges(const TopicSurvey& topic) { return topic.scans_with_ranges > 0; }

    /// Throws Error if there is nothing in any of the scans.
    void expect_ranges(const TopicSurvey& scans) const {
        if (!survey_.is_whole || has_ranges(scans)) {
            return;
        }
        const std::string number = std::to_string(scans.scans);
        if (scans.scans_read == 0) {
            throw Error(file_ + ": none of the " + number + " scans of " + scans.topic + " can be read; the first is " +
                        scans.first_fault);
        }
        throw Error(file_ + ": none of the " + number + " scans of " + scans.topic +
                    " has a range: they have no beams, or no beam of them has a return; there is nothing to map");
    }

    /// Whether a scan topic is in the namespace of the robot, or in frames that have its name in front.
    static bool is_of_robot(const TopicSurvey& scans, const std::string& robot) {
        const auto named = [&](const std::string& frame) { return frame.starts_with(robot + "/"); };
        return is_in_namespace(scans.topic, "/" + robot) || std::ranges::any_of(scans.scan_frames, named);
    }

    /// Finds what the topics and frames of the scans' robot have in front, and its transforms. They are laid over those
    /// that belong to no robot.
    void find_robot() {
        scan_frame_ = scan_.scan_frames.empty() ? "" : scan_.scan_frames.front();
        frame_prefix_ = scan_frame_.substr(0, scan_frame_.find('/') + 1);
        for (const auto& [name, tree] : survey_.transforms) {
            if (name.size() > namespace_.size() && is_in_namespace(scan_.topic, name)) {
                namespace_ = name;
            }
        }
        if (!options_.robot.empty() && is_in_namespace(scan_.topic, "/" + options_.robot)) {
            namespace_ = "/" + options_.robot;
        }
        if (namespace_.empty()) {
            namespace_ = shared_namespace();
        }
        const bool has_own = survey_.transforms.contains(namespace_) && !namespace_.empty();
        for (const auto& [name, tree] : survey_.transforms) {
            if (!has_own && !name.empty()) {
                tree_.set(tree);
            }
        }
        for (const std::string& name : {std::string(), namespace_}) {
            if (const auto found = survey_.transforms.find(name); found != survey_.transforms.end()) {
                tree_.set(found->second);
            }
        }
    }

    /// The first part of the scans' topic, if another topic of scans has another first part, and both have odometry.
    std::string shared_namespace() const {
        const auto first_part = [](const std::string& topic) { return topic.substr(0, topic.find('/', 1)); };
        std::set<std::string> with_scans;
        std::set<std::string> with_both;
        for (const TopicSurvey& topic : survey_.topics) {
            if (topic.kind == scan_.kind) {
                with_scans.insert(first_part(topic.topic));
            }
        }
        for (const TopicSurvey& topic : survey_.topics) {
            if (topic.kind == MessageKind::odometry && with_scans.contains(first_part(topic.topic))) {
                with_both.insert(first_part(topic.topic));
            }
        }
        const std::string own = first_part(scan_.topic);
        return with_both.size() > 1 && with_both.contains(own) ? own : "";
    }

    /// Leaves only the topics of the scans' robot, if it has any of these.
    Topics of_this_robot(Topics topics) const {
        const auto is_own = [&](const TopicSurvey& topic) {
            const auto named = [&](const auto& track) { return track.first.second.starts_with(frame_prefix_); };
            return (!namespace_.empty() && is_in_namespace(topic.topic, namespace_)) ||
                   (!frame_prefix_.empty() &&
                    (std::ranges::any_of(topic.tracks, named) || topic.gyro.frame_id().starts_with(frame_prefix_)));
        };
        if (std::ranges::any_of(topics, is_own)) {
            std::erase_if(topics, [&](const TopicSurvey& topic) { return !is_own(topic); });
        }
        return topics;
    }

    [[noreturn]] void fail_without_scans() const {
        std::string found;
        for (const TopicSurvey& topic : survey_.topics) {
            found += (found.empty() ? "" : ", ") + topic.topic + " (" + (topic.type.empty() ? "?" : topic.type) + ")";
        }
        throw Error(file_ + ": holds no laser scans; expected a topic of LaserScan or PointCloud2, found " +
                    (found.empty() ? "no messages" : found));
    }

    void choose_ground_truth() {
        const Topics poses = topics_where(survey_, [](const TopicSurvey& topic) {
            return topic.kind == MessageKind::odometry || topic.kind == MessageKind::pose;
        });
        if (!options_.ground_truth_topic.empty()) {
            use_ground_truth(find_requested(poses, options_.ground_truth_topic, "ground truth", file_));
            return;
        }
        Topics named = poses;
        std::erase_if(named, [&](const TopicSurvey& topic) {
            return !names_ground_truth(topic.topic) || topic.topic == options_.odom_topic;
        });
        named = of_this_robot(std::move(named));
        if (!named.empty()) {
            use_ground_truth(named.front());
        }
    }

    void use_ground_truth(const TopicSurvey& topic) {
        plan_.ground_truth_topic = topic.topic;
        for (const auto& [frames, track] : topic.tracks) {
            plan_.ground_truth_stamps = stamps_of(track.stamps(), "the ground truth " + topic.topic);
        }
    }

    void choose_odometry() {
        if (!options_.with_odometry) {
            assume("the odometry of the log is left out, as was asked for");
            return;
        }
        if (!options_.odom_topic.empty()) {
            const Topics usable = topics_where(survey_, [](const TopicSurvey& topic) { return has_poses(topic.kind); });
            const TopicSurvey& topic = find_requested(usable, options_.odom_topic, "odometry", file_);
            const std::size_t faults = plan_.faults.size();
            if (!use_odometry(topic) && plan_.faults.size() == faults) {
                throw UsageError(
                    file_ + ": the topic '" + topic.topic + "' has no odometry; expected " +
                    "a transform from a frame odom to the robot's frame, in it or above the laser's frame");
            }
            assume_none();
            return;
        }
        const Topics odometry =
            odometry_candidates([](const TopicSurvey& topic) { return topic.kind == MessageKind::odometry; });
        const Topics poses = odometry_candidates(
            [](const TopicSurvey& topic) { return topic.kind == MessageKind::pose && names_odometry(topic.topic); });
        const Topics transforms = topics_where(survey_, [](const TopicSurvey& topic) {
            return topic.kind == MessageKind::transforms && !names_static(topic.topic);
        });
        // What filters and wheel drivers publish under any name comes last; what is sent to the robot is none of it.
        const Topics estimates = odometry_candidates([](const TopicSurvey& topic) {
            return topic.kind == MessageKind::pose && topic.type.ends_with("/PoseWithCovarianceStamped") &&
                   !names_no_measurement(topic.topic);
        });
        const Topics velocities = odometry_candidates([](const TopicSurvey& topic) {
            return topic.kind == MessageKind::velocity && !names_no_measurement(topic.topic);
        });
        for (Topics topics : {odometry, poses, of_this_robot(transforms), estimates, velocities}) {
            while (!topics.empty()) {
                const TopicSurvey topic = plainest(topics, "odometry");
                if (use_odometry(topic)) {
                    return;
                }
                std::erase_if(topics, [&](const TopicSurvey& other) { return other.topic == topic.topic; });
            }
        }
        assume_none();
    }

    void assume_none() {
        if (plan_.odom_topic.empty()) {
            assume("no odometry; the motion has to be worked out from the scans");
        }
    }

    Topics odometry_candidates(const std::function<bool(const TopicSurvey&)>& condition) const {
        Topics topics = topics_where(survey_, [&](const TopicSurvey& topic) {
            return condition(topic) && topic.topic != plan_.ground_truth_topic && !names_ground_truth(topic.topic);
        });
        const auto unnamed = std::stable_partition(
            topics.begin(), topics.end(), [](const TopicSurvey& topic) { return names_odometry(topic.topic); });
        if (unnamed != topics.begin()) {
            topics.erase(unnamed, topics.end());
        }
        return of_this_robot(std::move(topics));
    }

    bool use_odometry(const TopicSurvey& topic) {
        if (topic.kind == MessageKind::transforms) {
            return use_transforms(topic);
        }
        const TrackSurvey track = topic.tracks.empty() ? TrackSurvey() : topic.tracks.begin()->second;
        if (!can_be_used(track, topic.topic)) {
            return false;
        }
        plan_.odom_topic = topic.topic;
        std::tie(plan_.odom_frame, plan_.robot_frame) = topic.tracks.begin()->first;
        return true;
    }

    /// \param is_path whether the track is one of the paths of several publishers
    bool can_be_used(const TrackSurvey& track, const std::string& name, bool is_path = false) {
        if (track.usable() == 0) {
            blame("the odometry " + name + " is not used: " +
                  (track.without_rotation() > 0
                       ? "the rotation of all its " + std::to_string(track.without_rotation()) +
                             " poses is 0,0,0,0 or no number"
                       : "none of its messages can be read"));
            return false;
        }
        if (!track.moves() && scan_.change.moves()) {
            blame("the odometry " + name + " is not used: it never moves, although the scans do");
            return false;
        }
        if (const std::vector<TrackSurvey> paths = track.paths(); !paths.empty()) {
            const std::size_t path = chosen_path(track, paths, name);
            if (!can_be_used(paths[path], name, true)) {
                return false;
            }
            plan_.odom_lineage = track.interleaved().lineage(path);
            return true;
        }
        if (options_.odom_path > 1 && !is_path) {
            throw UsageError(file_ + ": there is no path " + std::to_string(options_.odom_path) +
                             "; the poses of the odometry " + name + " are those of one publisher");
        }
        const StampRule stamps = track.stamps().rule("the odometry " + name);
        const StampRule& scan_stamps = plan_.lidars.front().stamps;
        const ClockLag scan_clock = clock_by(scan_stamps, scan_.clock, scan_.stamps);
        const ClockLag clock = clock_by(stamps, track.clock(), track.stamps());
        plan_.odom_interval_s = track.usual_interval_s();
        const double found_s = ClockLag::offset_s(scan_clock, clock).value_or(0.0);
        const bool is_another_clock = !options_.odom_delay_s && std::abs(found_s) > least_clock_offset_s;
        const double ahead_s = options_.odom_delay_s.value_or(is_another_clock ? found_s : 0.0);
        if (!ClockLag::overlap(clock, scan_clock, -ahead_s) && track.usable() > 1) {
            blame("the odometry " + name + " is not used: its stamps share no moment with those of the scans");
            return false;
        }
        // Turns and lengths were noted with the stamps of the messages.
        const bool stamps_are_good = scan_stamps.assumption.empty() && stamps.assumption.empty();
        if (const std::string fault = stamps_are_good ? length_fault(scan_.way, track.way(), ahead_s) : "";
            !fault.empty()) {
            blame("the odometry " + name + " is not used: " + fault);
            return false;
        }
        plan_.odom_stamps = stamps_of(track.stamps(), "the odometry " + name);
        plan_.odom_clock_offset_ns = std::llround(-1e9 * ahead_s);
        if (is_another_clock) {
            assume("the clock of the odometry " + name + " is " + fixed_text(std::abs(ahead_s), 3) + " s " +
                   (ahead_s > 0.0 ? "ahead of" : "behind") +
                   " that of the scans, as the times of recording show; this is taken off its stamps");
        }
        if (stamps_are_good) {
            plan_.odom_lag = turn_lag(scan_.turns, track.heading(), ahead_s);
            plan_.takes_off_lag = !options_.odom_delay_s;
        }
        return true;
    }

    /// Of the paths of several publishers, the one that was asked for, or the one that moves and whose turns fit those
    /// of the scans best, or else the longest.
    std::size_t chosen_path(const TrackSurvey& track, const std::vector<TrackSurvey>& paths, const std::string& name) {
        std::string counts;
        for (std::size_t path = 0; path < paths.size(); ++path) {
            if (paths[path].usable() >= InterleavedPaths::least_poses) {
                counts += (counts.empty() ? "" : ", ") + std::to_string(path + 1) + " with " +
                          std::to_string(paths[path].usable());
            }
        }
        const std::string found = "the poses of the odometry " + name + " are those of several publishers, which are " +
                                  "interleaved (paths " + counts + " poses)";
        if (options_.odom_path > paths.size()) {
            throw UsageError(file_ + ": there is no path " + std::to_string(options_.odom_path) + "; " + found);
        }
        if (options_.odom_path > 0) {
            assume(found + "; path " + std::to_string(options_.odom_path) + " is used, as was asked for");
            return options_.odom_path - 1;
        }
        const auto worth = [&](std::size_t number) {
            const TrackSurvey& path = paths[number];
            const std::optional<TurnLag> lag = turn_lag(scan_.turns, path.heading(), 0.0);
            // Fits that differ by less than a half are the same, as far as two such paths can be told apart.
            const double fit = lag ? -std::round(std::log2(std::max(lag->share, 1e-3))) : 0.0;
            std::size_t poses = 0;
            for (const std::size_t each : track.interleaved().lineage(number)) {
                poses += paths[each].usable();
            }
            return std::tuple(path.moves(), fit, poses);
        };
        std::size_t number = 0;
        for (std::size_t other = 1; other < paths.size(); ++other) {
            number = worth(other) > worth(number) ? other : number;
        }
        blame(found + "; path " + std::to_string(number + 1) + " is used; --odom-path names another");
        return number;
    }

    /// Takes the odometry from transforms: odom_from_robot, where odom is the frame that has such a name, or otherwise
    /// the root, and robot is the frame directly below it on the way to the laser. If the topic does not have that
    /// transform, the laser is not in the tree; then it is a transform from a frame with such a name. Returns false if
    /// there is none.
    bool use_transforms(const TopicSurvey& topic) {
        const std::vector<std::string> frames = tree_.with_ancestors(scan_frame_);
        const auto named = std::find_if(frames.begin(), frames.end(), names_odometry);
        const auto odom = named == frames.end() ? frames.end() - 1 : named;
        auto track = odom == frames.begin() ? topic.tracks.end() : topic.tracks.find({*odom, *(odom - 1)});
        if (track == topic.tracks.end()) {
            track = std::ranges::find_if(topic.tracks, [&](const auto& each) {
                const auto& [parent, child] = each.first;
                return names_odometry(parent) && (frame_prefix_.empty() || parent.starts_with(frame_prefix_));
            });
        }
        if (track == topic.tracks.end()) {
            return false;
        }
        const auto& [parent, child] = track->first;
        if (!can_be_used(track->second, parent + " -> " + child + " in " + topic.topic)) {
            return false;
        }
        plan_.odom_topic = topic.topic;
        plan_.odom_frame = parent;
        plan_.robot_frame = child;
        plan_.odom_is_transform = true;
        if (!names_odometry(parent)) {
            assume("no frame is named odom; the transform " + parent + " -> " + child + " is taken as odometry");
        }
        return true;
    }

    void find_mountings() {
        const std::vector<std::string>& frames = scan_.scan_frames;
        if (frames.size() > 1) {
            assume("the scans of " + scan_.topic + " are in " + std::to_string(frames.size()) + " frames (" +
                   joined(frames) + "); " +
                   (options_.laser_pose ? "all are placed by the given pose of the laser"
                                        : "each is placed by its own frame"));
        }
        if (options_.laser_pose) {
            if (lidars_.size() > 1) {
                throw UsageError(file_ +
                                 ": --laser-pose is the pose of one lidar; expected one topic of scans, or the poses "
                                 "of all lidars in the log's transforms");
            }
            const auto& [x, y, theta] = *options_.laser_pose;
            plan_.robot_from_other_laser =
                Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ());
            return;
        }
        const std::string& robot = robot_ = robot_above_laser();
        place_frames(scan_, robot);
        place_other_lidars(robot);
        name_unused_lidars(robot);
    }

    void place_frames(const TopicSurvey& lidar, const std::string& robot) {
        for (const std::string& frame : lidar.scan_frames) {
            if (const auto mounting = tree_.find(robot, frame)) {
                plan_.robot_from_laser[frame] = *mounting;
            }
            for (const std::string& transform : tree_.without_rotation(robot, frame)) {
                assume("the transform " + transform +
                       " has the rotation 0,0,0,0, which is none; it is taken not to turn");
            }
        }
    }

    /// Leaves out the lidars of which it is not known where they are, or when their scans were taken.
    void place_other_lidars(const std::string& robot) {
        for (auto lidar = lidars_.begin() + 1; lidar != lidars_.end();) {
            const double ahead_s = ClockLag::offset_s(scan_.clock, lidar->clock).value_or(0.0);
            std::string fault;
            if (!is_placed(*lidar, robot)) {
                fault = "no transform places their frame on '" + robot + "'";
            } else if (std::abs(ahead_s) > least_clock_offset_s) {
                fault = "their clock differs from that of " + scan_.topic + " by " + fixed_text(std::abs(ahead_s), 3) +
                        " s";
            }
            if (fault.empty()) {
                place_frames(*lidar, robot);
                ++lidar;
            } else {
                blame("the scans of " + lidar->topic + " are not used: " + fault);
                std::erase_if(plan_.lidars, [&](const LidarPlan& plan) { return plan.topic == lidar->topic; });
                lidar = lidars_.erase(lidar);
            }
        }
    }

    bool is_placed(const TopicSurvey& lidar, const std::string& robot) const {
        return !lidar.scan_frames.empty() && tree_.find(robot, lidar.scan_frames.front()).has_value();
    }

    /// Says how the robot's other lidars would be used. They are not used without being asked for, because a topic may
    /// also hold filtered or merged scans of the same lidar, or those of one that tilts.
    void name_unused_lidars(const std::string& robot) {
        std::vector<std::string> unused;
        for (const TopicSurvey& topic : of_robot(of_kind(MessageKind::scan))) {
            const bool is_new = std::ranges::none_of(
                topic.scan_frames, [&](const std::string& frame) { return plan_.robot_from_laser.contains(frame); });
            if (is_new && is_placed(topic, robot)) {
                unused.push_back(topic.topic);
            }
        }
        if (!unused.empty() && scan_.kind == MessageKind::scan && options_.scan_topic.empty()) {
            assume("the robot's other lidars are left out (" + joined(unused) +
                   "); to use them together: --scan-topic " + joined_by_commas(scan_.topic, unused));
        }
    }

    /// The frame of the robot, from which the lasers are placed. If the transforms do not connect the odometry's frame
    /// with the laser, it is the laser's highest known ancestor below odom or map.
    std::string robot_above_laser() {
        if (!plan_.robot_frame.empty() && tree_.find(plan_.robot_frame, scan_frame_)) {
            return plan_.robot_frame;
        }
        const std::vector<std::string> frames = tree_.with_ancestors(scan_frame_);
        const auto fixed = std::find_if(frames.begin() + 1, frames.end(), names_fixed_frame);
        const std::string& robot = *(fixed - 1);
        const std::string wanted = plan_.robot_frame.empty() ? "the robot" : "'" + plan_.robot_frame + "'";
        if (robot == scan_frame_) {
            assume("no transform from the laser '" + scan_frame_ + "' to " + wanted +
                   "; the laser is taken to be at the robot's origin");
            plan_.robot_from_other_laser = Eigen::Isometry3d::Identity();
        } else if (!plan_.robot_frame.empty()) {
            assume("no transform from the laser '" + scan_frame_ + "' to " + wanted + "; '" + robot +
                   "' is taken as the robot");
        }
        return robot;
    }

    static bool gives_several_echoes(const TopicSurvey& lidar) { return lidar.type.ends_with("/MultiEchoLaserScan"); }

    void find_echo() {
        plan_.echo = options_.strongest_echo ? Echo::strongest : Echo::first;
        const auto echoes = std::ranges::find_if(lidars_, gives_several_echoes);
        if (echoes != lidars_.end()) {
            assume("of each beam of " + echoes->topic + " the " +
                   (options_.strongest_echo ? "strongest echo is used"
                                            : "first echo is used; --set log.echo=strongest uses the strongest"));
        }
    }

    void find_heights() {
        const auto cloud = std::ranges::find(lidars_, MessageKind::cloud, &TopicSurvey::kind);
        if (cloud == lidars_.end()) {
            return;
        }
        plan_.cloud_beams = options_.cloud_beams;
        plan_.height = options_.height;
        if (plan_.height) {
            return;
        }
        const auto mounting = plan_.robot_from_laser.find(cloud->scan_frames.empty() ? "" : cloud->scan_frames.front());
        const bool is_known = mounting != plan_.robot_from_laser.end() && !plan_.robot_from_other_laser;
        const HeightBand band = is_known ? band_around_lidar(mounting->second.translation().z()) : band_around_unknown;
        assume("the points of " + cloud->topic + " between " + fixed_text(band.min_m, 2) + " and " +
               fixed_text(band.max_m, 2) + " m above " +
               (is_known ? "the robot's origin" : "the lidar, whose height on the robot is unknown,") +
               " become its scans; --height MIN,MAX takes others");
    }

    void find_no_returns() {
        for (const TopicSurvey& lidar : lidars_) {
            RangeRules ranges{.no_returns = {}, .range_max_m = options_.range_max_m};
            if (!options_.no_return_m.empty()) {
                ranges.no_returns = named_no_returns(options_.no_return_m);
                const bool has_readings = lidar.kind == MessageKind::scan;
                for (const std::string& line :
                     lidar.piles.never_read(has_readings ? options_.no_return_m : std::vector<double>{})) {
                    assume(lidars_.size() > 1 ? lidar.topic + ": " + line : line);
                }
            } else {
                ranges.no_returns = lidar.piles.find(false);
                for (const std::string& line : ranges.no_returns.lines()) {
                    assume(lidars_.size() > 1 ? lidar.topic + ": " + line : line);
                }
            }
            lidar_plan(lidar).ranges = std::move(ranges);
        }
    }

    LidarPlan& lidar_plan(const TopicSurvey& lidar) {
        return *std::ranges::find(plan_.lidars, lidar.topic, &LidarPlan::topic);
    }

    void judge_units() {
        for (const TopicSurvey& lidar : lidars_) {
            if (const std::string fault = lidar.unit.fault(); !fault.empty()) {
                blame(lidar.topic + ": " + fault);
            }
            if (lidar.scans_in_degrees > 0) {
                assume("the angles of " + std::to_string(lidar.scans_in_degrees) + " scans of " + lidar.topic +
                       " are taken for degrees, because as radians their beams would cover several turns");
            }
        }
    }

    void find_sweep() {
        for (const TopicSurvey& lidar : lidars_) {
            SweepTiming& sweep = lidar_plan(lidar).sweep;
            sweep = find_sweep_timing(lidar.rate);
            if (!sweep.doubt.empty()) {
                assume(sweep.doubt);
            }
        }
    }

    /// Says which options change nothing in this log, so that nobody believes that they do.
    void note_options_without_effect() {
        const UsedOfLog used{.clouds = std::ranges::count(lidars_, MessageKind::cloud, &TopicSurvey::kind) > 0,
                             .echoes = std::ranges::any_of(lidars_, gives_several_echoes),
                             .odometry = !plan_.odom_topic.empty()};
        for (const std::string& line : options_without_effect(options_, used)) {
            assume(line);
        }
    }

    void choose_imu() {
        if (options_.imu_topic == "none" || plan_.odom_topic.empty()) {
            return;
        }
        const Topics all =
            topics_where(survey_, [](const TopicSurvey& topic) { return topic.kind == MessageKind::inertial; });
        Topics usable = all;
        std::erase_if(usable, [](const TopicSurvey& topic) { return topic.gyro.readings() == 0; });
        plan_.imu_is_named = !options_.imu_topic.empty();
        if (plan_.imu_is_named) {
            use_imu(find_requested(all, options_.imu_topic, "inertial", file_));
        } else if (!usable.empty()) {
            use_imu(plainest(of_this_robot(usable), "inertial"));
        }
    }

    void use_imu(const TopicSurvey& topic) {
        if (topic.gyro.readings() == 0) {
            blame("the inertial sensor " + topic.topic + " is not used: it gives no angular velocities");
            return;
        }
        const double ahead_s = ClockLag::offset_s(scan_.clock, topic.gyro.clock()).value_or(0.0);
        const bool is_another_clock = std::abs(ahead_s) > least_clock_offset_s;
        if (!ClockLag::overlap(topic.gyro.clock(), scan_.clock, is_another_clock ? -ahead_s : 0.0)) {
            blame("the inertial sensor " + topic.topic +
                  " is not used: its stamps share no moment with those of the scans");
            return;
        }
        if (is_another_clock) {
            plan_.imu_clock_offset_ns = std::llround(-1e9 * ahead_s);
            assume("the clock of the inertial sensor " + topic.topic + " is " + fixed_text(std::abs(ahead_s), 3) +
                   " s " + (ahead_s > 0.0 ? "ahead of" : "behind") +
                   " that of the scans, as the times of recording show; this is taken off its stamps");
        }
        plan_.imu_topic = topic.topic;
        plan_.imu_upwards = upwards_of(topic);
    }

    /// By the transforms, or, where they lack the sensor or contradict gravity, by gravity.
    Eigen::Vector3d upwards_of(const TopicSurvey& topic) {
        const std::optional<Eigen::Vector3d> gravity = topic.gyro.upwards();
        const std::string& robot = robot_.empty() ? plan_.robot_frame : robot_;
        const auto robot_from_imu = tree_.find(robot, topic.gyro.frame_id());
        if (!robot_from_imu) {
            return gravity.value_or(Eigen::Vector3d::UnitZ());
        }
        const Eigen::Vector3d upwards = robot_from_imu->linear().row(2).transpose();
        if (gravity && gravity->dot(upwards) < least_agreement) {
            assume("the transform of the inertial sensor " + topic.topic + " contradicts gravity, which it measures " +
                   "in another direction than downwards; the sensor is taken to be mounted as gravity shows");
            return *gravity;
        }
        return upwards;
    }

    const LogSurvey& survey_;
    const LogOptions& options_;
    const std::string& file_;
    Topics lidars_;             ///< the topics of scans and clouds that are used
    TopicSurvey scan_;          ///< the first of them
    std::string scan_frame_;    ///< of the first scan
    std::string namespace_;     ///< of the topics of the scans' robot; empty: it has none of its own
    std::string frame_prefix_;  ///< of the frames of that robot, up to and with the slash; may be empty
    TransformTree tree_;        ///< of that robot
    std::string robot_;         ///< the frame from which the lasers are placed; empty: none
    LogPlan plan_;
};

}  // namespace

LogPlan plan_log(const LogSurvey& survey, const LogOptions& options, const std::string& file) {
    return Planner(survey, options, file).plan();
}

}  // namespace ddtool
