#include "info_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

#include "log_options.hpp"
#include "report/table.hpp"
#include "sim/pose2_json.hpp"

namespace ddtool {
namespace {

constexpr double degrees_per_rad = 180.0 / std::numbers::pi;

std::string fixed(double number, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
    return text.data();
}

/// When something began: a date, or seconds where the clock began with the log.
std::string beginning(std::int64_t time_ns) {
    constexpr std::int64_t first_dated_s = 100LL * 24 * 3600;
    const auto seconds = static_cast<std::time_t>(time_ns / 1'000'000'000);
    if (seconds < first_dated_s) {
        return fixed(1e-9 * static_cast<double>(time_ns), 1) + " s on its own clock";
    }
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    std::array<char, 64> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts);
    return text.data();
}

/// From when to when a log is: by its times of recording or, if they say nothing, by the stamps of its scans.
struct LogExtent {
    std::int64_t first_ns = 0;
    double duration_s = 0.0;
};

LogExtent extent_of(const LogInfo& info) {
    const LogExtent recorded{info.inventory.first_ns(), info.inventory.duration_s()};
    return recorded.duration_s > 0.0 || !info.use ? recorded : LogExtent{info.use->first_ns, info.use->duration_s()};
}

std::string used_as(const std::string& topic, const LogSummary& summary) {
    if (std::ranges::count(summary.more_scan_topics, topic) > 0) {
        return "scans";
    }
    if (topic == summary.scan_topic) {
        return topic == summary.odom_topic ? "scans, odometry" : "scans";
    }
    if (topic == summary.odom_topic) {
        return "odometry";
    }
    if (topic == summary.imu_topic) {
        return "turns";
    }
    return topic == summary.ground_truth_topic ? "ground truth" : "";
}

std::string joined_frames(const TopicInventory& topic) {
    constexpr std::size_t max_shown = 3;
    std::string text;
    std::size_t shown = 0;
    for (const std::string& frame : topic.frames) {
        if (shown++ == max_shown) {
            return text + ", and " + std::to_string(topic.frames.size() - max_shown) + " more";
        }
        text += (text.empty() ? "" : ", ") + frame;
    }
    return text;
}

std::string topic_table(const LogInfo& info) {
    Table table({{"topic"}, {"type"}, {"messages"}, {"rate, Hz", 1}, {"used as"}, {"frames"}});
    const LogSummary summary = info.use ? info.use->summary : LogSummary{};
    for (const TopicInventory& topic : info.inventory.topics) {
        table.add_row({topic.topic, topic.type, static_cast<std::int64_t>(topic.messages), topic.rate_hz(),
                       used_as(topic.topic, summary), joined_frames(topic)});
    }
    return table.text();
}

double scans_hz(const LogUse& use) {
    const double duration_s = use.duration_s();
    return duration_s > 0.0 ? static_cast<double>(use.summary.scans - 1) / duration_s : 0.0;
}

std::string beams_text(const LogUse& use) {
    return use.fewest_beams == use.most_beams
               ? std::to_string(use.most_beams)
               : std::to_string(use.fewest_beams) + " to " + std::to_string(use.most_beams);
}

/// "; its stamps are 43 +- 4 ms late (43 ms taken off)".
std::string delay_text(const LogSummary& summary) {
    std::string text;
    if (const auto& delay = summary.odom_delay) {
        text = "; its stamps are " + fixed(1e3 * std::abs(delay->late_s), 0) + " +- " + fixed(1e3 * delay->sigma_s, 0) +
               " ms " + (delay->late_s < 0.0 ? "earlier" : "later") + " than the scans', by the turns of both";
    }
    if (summary.odom_delay_removed_s != 0.0) {
        text += "; " + fixed(1e3 * summary.odom_delay_removed_s, 0) + " ms are taken off";
    }
    return text;
}

Json delay_json(const LogSummary& summary) {
    return {{"late_s", summary.odom_delay ? Json(summary.odom_delay->late_s) : Json()},
            {"sigma_s", summary.odom_delay ? Json(summary.odom_delay->sigma_s) : Json()},
            {"removed_s", summary.odom_delay_removed_s}};
}

std::string scans_text(const LogUse& use) {
    std::string text = "scans     " + std::to_string(use.summary.scans) + " of " + beams_text(use) + " beams over " +
                       fixed(degrees_per_rad * use.field_of_view_rad, 1) + " deg" +
                       (use.lidars > 1 ? " of " + std::to_string(use.lidars) + " lidars" : "") + ", up to " +
                       fixed(use.range_max_m, 1) + " m";
    if (scans_hz(use) > 0.0) {
        text += ", " + fixed(scans_hz(use), 1) + " Hz; longest gap " + fixed(use.longest_gap_s, 2) + " s";
    }
    text += "; " + fixed(100.0 * static_cast<double>(use.returns) / static_cast<double>(use.beams), 0) +
            " % of the beams have a range\n";
    if (use.with_ground_truth > 0) {
        text += "truth     for " + std::to_string(use.with_ground_truth) + " scans\n";
    }
    return text;
}

std::string inputs_text(const LogUse& use) {
    std::string scans = use.summary.scan_topic;
    for (const std::string& topic : use.summary.more_scan_topics) {
        scans += " and " + topic;
    }
    const std::string turns = use.summary.imu_topic.empty() ? "" : ", turns " + use.summary.imu_topic;
    const std::string odometry = use.summary.has_odometry
                                     ? "odometry " + use.summary.odom_topic + " (" + fixed(use.odometry_m, 1) +
                                           " m driven" + delay_text(use.summary) + ")"
                                     : "no odometry: the motion is worked out from the scans";
    return "uses      scans " + scans + ", " + odometry + turns + "\n";
}

std::string lasers_text(const LogUse& use) {
    std::string text;
    for (const Pose2& laser : use.robot_from_lasers) {
        text += (text.empty() ? "" : "; ") + ("x " + fixed(laser.x_m, 3)) + " m, y " + fixed(laser.y_m, 3) +
                " m, yaw " + fixed(degrees_per_rad * laser.theta_rad, 1) + " deg";
    }
    return "laser     " + text + " on the robot\n";
}

/// The lines with the word in front of the first one, indented to its width.
std::string under(const std::string& word, const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += (text.empty() ? word : std::string(word.size(), ' ')) + line + "\n";
    }
    return text;
}

/// A text without the name of the file in front.
std::string without_file(const std::string& file, const std::string& text) {
    return text.starts_with(file + ": ") ? text.substr(file.size() + 2) : text;
}

/// The assumptions that were made because the log lacks something or contradicts itself, without the name of the file
/// in front.
std::vector<std::string> assumptions(const std::string& file, const LogUse& use) {
    std::vector<std::string> lines;
    if (use.stamps_back > 0) {
        lines.push_back(
            std::to_string(use.stamps_back) + (use.stamps_back == 1 ? " scan is stamped" : " scans are stamped") +
            " before the scan in front, by up to " + fixed(use.most_back_s, 2) + " s; the order of the file is kept");
    }
    for (const std::string& assumption : use.summary.assumptions) {
        lines.push_back(without_file(file, assumption));
    }
    return lines;
}

constexpr std::size_t most_in_one_line = 3;

/// The first of several texts in one line, without the name of the file in front of each.
std::string in_one_line(const std::string& file, const std::vector<std::string>& texts) {
    std::string line;
    for (std::size_t i = 0; i < std::min(texts.size(), most_in_one_line); ++i) {
        line += (i == 0 ? "" : "; ") + without_file(file, texts[i]);
    }
    return line + (texts.size() > most_in_one_line ? "; and more, listed above" : "");
}

std::string damage_text(const std::string& file, const LogDamage& damage) {
    if (damage.problems == 0) {
        return "damage    none\n";
    }
    return "damage    problems: " + std::to_string(damage.problems) +
           "; bytes known to be lost: " + std::to_string(damage.bytes_lost) + "; " + in_one_line(file, damage.first) +
           "\n";
}

/// The command line that runs over the log, with the same options.
std::string next_command(const std::string& file, const LogInfo& info) {
    return "ddtool slam --log " + shell_word(file) + info.options;
}

Json topic_json(const TopicInventory& topic, const LogSummary& summary) {
    return {{"topic", topic.topic},       {"type", topic.type},
            {"encoding", topic.encoding}, {"messages", topic.messages},
            {"rate_hz", topic.rate_hz()}, {"first_ns", topic.first_ns},
            {"last_ns", topic.last_ns},   {"used_as", used_as(topic.topic, summary)},
            {"frames", topic.frames}};
}

Json use_json(const std::string& file, const LogUse& use) {
    return {{"scan_topic", use.summary.scan_topic},
            {"more_scan_topics", use.summary.more_scan_topics},
            {"odom_topic", use.summary.odom_topic},
            {"imu_topic", use.summary.imu_topic},
            {"ground_truth_topic", use.summary.ground_truth_topic},
            {"has_odometry", use.summary.has_odometry},
            {"scans", use.summary.scans},
            {"scans_hz", scans_hz(use)},
            {"longest_gap_s", use.longest_gap_s},
            {"stamps_back", use.stamps_back},
            {"most_back_s", use.most_back_s},
            {"fewest_beams", use.fewest_beams},
            {"most_beams", use.most_beams},
            {"field_of_view_rad", use.field_of_view_rad},
            {"range_max_m", use.range_max_m},
            {"beams", use.beams},
            {"returns", use.returns},
            {"odometry_m", use.odometry_m},
            {"odom_delay", delay_json(use.summary)},
            {"with_ground_truth", use.with_ground_truth},
            {"robot_from_lasers", use.robot_from_lasers},
            {"assumptions", assumptions(file, use)}};
}

}  // namespace

LogProblemHandler LogDamage::handler() {
    return [this](const LogProblem& problem) {
        ++problems;
        bytes_lost += problem.bytes_lost;
        if (first.size() < max_told) {
            first.push_back(problem.what);
        }
    };
}

Json info_json(const std::string& file, const LogInfo& info) {
    Json topics = Json::array();
    for (const TopicInventory& topic : info.inventory.topics) {
        topics.push_back(topic_json(topic, info.use ? info.use->summary : LogSummary{}));
    }
    const LogExtent extent = extent_of(info);
    Json report{{"file", file},
                {"format", info.inventory.format},
                {"messages", info.inventory.messages()},
                {"first_ns", extent.first_ns},
                {"duration_s", extent.duration_s},
                {"topics", topics},
                {"usable", info.use.has_value()}};
    if (info.use) {
        report["use"] = use_json(file, *info.use);
        report["next"] = next_command(file, info);
    } else {
        report["unusable"] = info.unusable;
    }
    report["damage"] = {
        {"problems", info.damage.problems}, {"bytes_lost", info.damage.bytes_lost}, {"first", info.damage.first}};
    return report;
}

/// What a new user must know stands in the last five lines.
std::string info_text(const std::string& file, const LogInfo& info) {
    const LogInventory& inventory = info.inventory;
    const LogExtent extent = extent_of(info);
    std::string text = file + ": " + inventory.format + ", " + std::to_string(inventory.messages()) + " messages, " +
                       fixed(extent.duration_s, 1) + " s from " + beginning(extent.first_ns) + "\n\n" +
                       topic_table(info) + "\n";
    const std::vector<std::string> assumed = info.use ? assumptions(file, *info.use) : std::vector<std::string>{};
    if (info.use) {
        text += scans_text(*info.use);
    }
    if (assumed.size() > most_in_one_line) {
        text += under("assumed   ", assumed);
    }
    if (info.damage.first.size() > most_in_one_line) {
        text += under("damage    ", info.damage.first);
    }
    if (info.use) {
        text += "\n" + inputs_text(*info.use) + lasers_text(*info.use) + "assumed   " +
                (assumed.empty() ? "nothing" : in_one_line(file, assumed)) + "\n";
    }
    return text + damage_text(file, info.damage) + "usable    " +
           (info.use ? "yes; next: " + next_command(file, info) : "no: " + without_file(file, info.unusable)) + "\n";
}

}  // namespace ddtool
