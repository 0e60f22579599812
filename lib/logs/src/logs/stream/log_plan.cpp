#include "logs/stream/log_plan.hpp"

#include <algorithm>
#include <functional>

#include "ddtool/base/error.hpp"
#include "logs/stream/topic_names.hpp"

namespace ddtool {
namespace {

using Topics = std::vector<TopicSurvey>;

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
        choose_scan();
        choose_ground_truth();
        choose_odometry();
        find_mounting();
        find_no_returns();
        plan_.has_information = survey_.has_information;
        return plan_;
    }

private:
    void assume(const std::string& text) { plan_.assumptions.push_back(file_ + ": " + text); }

    /// Chooses the topic with the shortest name: /scan rather than /scan_filtered.
    const TopicSurvey& plainest(const Topics& topics, const std::string& what) {
        const auto shorter = [](const TopicSurvey& a, const TopicSurvey& b) { return a.topic.size() < b.topic.size(); };
        const TopicSurvey& chosen = *std::min_element(topics.begin(), topics.end(), shorter);
        if (topics.size() > 1) {
            assume("several " + what + " topics (" + names_of(topics) + "); using " + chosen.topic);
        }
        return chosen;
    }

    void choose_scan() {
        const Topics scans =
            topics_where(survey_, [](const TopicSurvey& topic) { return topic.kind == MessageKind::scan; });
        if (!options_.scan_topic.empty()) {
            scan_ = find_requested(scans, options_.scan_topic, "scan", file_);
        } else if (scans.empty()) {
            fail_without_scans();
        } else {
            scan_ = plainest(scans, "scan");
        }
        plan_.scan_topic = scan_.topic;
    }

    [[noreturn]] void fail_without_scans() const {
        std::string found;
        for (const TopicSurvey& topic : survey_.topics) {
            found += (found.empty() ? "" : ", ") + topic.topic + " (" + (topic.type.empty() ? "?" : topic.type) + ")";
        }
        throw Error(file_ + ": holds no laser scans; expected a LaserScan topic, found " +
                    (found.empty() ? "no messages" : found));
    }

    void choose_ground_truth() {
        const Topics poses = topics_where(survey_, [](const TopicSurvey& topic) {
            return topic.kind == MessageKind::odometry || topic.kind == MessageKind::pose;
        });
        if (!options_.ground_truth_topic.empty()) {
            plan_.ground_truth_topic = find_requested(poses, options_.ground_truth_topic, "ground truth", file_).topic;
            return;
        }
        const auto named = std::find_if(poses.begin(), poses.end(), [&](const TopicSurvey& topic) {
            return names_ground_truth(topic.topic) && topic.topic != options_.odom_topic;
        });
        plan_.ground_truth_topic = named == poses.end() ? "" : named->topic;
    }

    void choose_odometry() {
        if (!options_.odom_topic.empty()) {
            const Topics usable = topics_where(survey_, [](const TopicSurvey& topic) {
                return topic.kind != MessageKind::scan && topic.kind != MessageKind::other;
            });
            use_odometry(find_requested(usable, options_.odom_topic, "odometry", file_));
            return;
        }
        const Topics odometry =
            odometry_candidates([](const TopicSurvey& topic) { return topic.kind == MessageKind::odometry; });
        const Topics poses = odometry_candidates(
            [](const TopicSurvey& topic) { return topic.kind == MessageKind::pose && names_odometry(topic.topic); });
        const Topics transforms = topics_where(survey_, [](const TopicSurvey& topic) {
            return topic.kind == MessageKind::transforms && !names_static(topic.topic);
        });
        for (const Topics& topics : {odometry, poses, transforms}) {
            if (!topics.empty() && use_odometry(plainest(topics, "odometry"))) {
                return;
            }
        }
        assume("no odometry; the robot's own motion is unknown and taken as none");
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
        return topics;
    }

    bool use_odometry(const TopicSurvey& topic) {
        if (topic.kind == MessageKind::transforms) {
            return use_transforms(topic);
        }
        plan_.odom_topic = topic.topic;
        plan_.robot_frame = topic.child_frame_id;
        return true;
    }

    /// Takes the odometry from transforms: odom_from_robot, where odom is the frame that has such a name, or otherwise
    /// the root, and robot is the frame directly below it on the way to the laser. Returns false if odom would be the
    /// laser's own frame.
    bool use_transforms(const TopicSurvey& topic) {
        const std::vector<std::string> frames = survey_.transforms.with_ancestors(scan_.frame_id);
        const auto named = std::find_if(frames.begin(), frames.end(), names_odometry);
        const auto odom = named == frames.end() ? frames.end() - 1 : named;
        if (odom == frames.begin()) {
            return false;
        }
        plan_.odom_topic = topic.topic;
        plan_.odom_frame = *odom;
        plan_.robot_frame = *(odom - 1);
        if (named == frames.end()) {
            assume("no frame is named odom; the transform " + plan_.odom_frame + " -> " + plan_.robot_frame +
                   " is taken as odometry");
        }
        return true;
    }

    void find_mounting() {
        if (options_.laser_pose) {
            const auto& [x, y, theta] = *options_.laser_pose;
            plan_.robot_from_laser =
                Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ());
            return;
        }
        const auto mounting =
            plan_.robot_frame.empty() ? std::nullopt : survey_.transforms.find(plan_.robot_frame, scan_.frame_id);
        plan_.robot_from_laser = mounting ? *mounting : guess_mounting();
    }

    /// For logs whose transforms do not connect the odometry's frame with the laser. Takes the laser's highest known
    /// ancestor below odom or map for the robot.
    Eigen::Isometry3d guess_mounting() {
        std::vector<std::string> frames = survey_.transforms.with_ancestors(scan_.frame_id);
        const auto fixed = std::find_if(frames.begin() + 1, frames.end(), names_fixed_frame);
        const std::string& robot = *(fixed - 1);
        const std::string wanted = plan_.robot_frame.empty() ? "the robot" : "'" + plan_.robot_frame + "'";
        if (robot == scan_.frame_id) {
            assume("no transform from the laser '" + scan_.frame_id + "' to " + wanted +
                   "; the laser is taken to be at the robot's origin");
            return Eigen::Isometry3d::Identity();
        }
        if (!plan_.robot_frame.empty()) {
            assume("no transform from the laser '" + scan_.frame_id + "' to " + wanted + "; '" + robot +
                   "' is taken as the robot");
        }
        return survey_.transforms.find(robot, scan_.frame_id).value_or(Eigen::Isometry3d::Identity());
    }

    void find_no_returns() {
        plan_.ranges.range_max_m = options_.range_max_m;
        if (!options_.no_return_m.empty()) {
            plan_.ranges.no_returns = named_no_returns(options_.no_return_m);
            return;
        }
        plan_.ranges.no_returns = scan_.piles.find(false);
        for (const std::string& line : plan_.ranges.no_returns.lines()) {
            assume(line);
        }
    }

    const LogSurvey& survey_;
    const LogOptions& options_;
    const std::string& file_;
    TopicSurvey scan_;
    LogPlan plan_;
};

}  // namespace

LogPlan plan_log(const LogSurvey& survey, const LogOptions& options, const std::string& file) {
    return Planner(survey, options, file).plan();
}

}  // namespace ddtool
