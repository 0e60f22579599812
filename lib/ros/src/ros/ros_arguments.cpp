#include "ros/ros_arguments.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr double longest_tolerance_s = 10.0;

bool is_name_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Whether ROS 2 takes the word as a name: letters, digits and '_', the first no digit.
bool is_ros_word(std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, is_name_letter) &&
           std::isdigit(static_cast<unsigned char>(word.front())) == 0;
}

/// Whether it is a name of a topic or namespace: words with '/' between them, and "/" or "~/" in front if at all.
bool is_ros_name(std::string_view name) {
    name.remove_prefix(name.starts_with("~/") ? 2 : name.starts_with('/') ? 1 : 0);
    for (;;) {
        const std::size_t slash = name.find('/');
        if (!is_ros_word(name.substr(0, slash))) {
            return false;
        }
        if (slash == std::string_view::npos) {
            return true;
        }
        name.remove_prefix(slash + 1);
    }
}

void expect_name(const std::string& word, std::string_view name) {
    if (!is_ros_name(name)) {
        throw UsageError("--ros-args: '" + word + "': '" + std::string(name) +
                         "' is no name of ROS 2; expected letters, digits and _ with / between, such as /front/scan");
    }
}

/// The two sides of FROM:=TO, without a "node:" in front. A rule for another node has no effect here.
struct Assignment {
    std::string left;
    std::string right;
    bool is_for_this_node = true;
};

Assignment assignment_in(const std::string& word, const std::string& node, const std::string& form) {
    const std::size_t middle = word.find(":=");
    if (middle == std::string::npos || middle == 0 || middle + 2 == word.size()) {
        throw UsageError("--ros-args: '" + word + "': expected " + form);
    }
    Assignment parts{.left = word.substr(0, middle), .right = word.substr(middle + 2)};
    if (const std::size_t colon = parts.left.find(':'); colon != std::string::npos) {
        parts.is_for_this_node = parts.left.substr(0, colon) == node;
        parts.left.erase(0, colon + 1);
    }
    return parts;
}

void take_remapping(RosArguments& arguments, const std::string& word) {
    const Assignment rule = assignment_in(word, arguments.node, "FROM:=TO, such as scan:=/front/scan");
    if (!rule.is_for_this_node) {
        return;
    }
    if (rule.left == "__ns") {
        if (rule.right != "/") {
            expect_name(word, rule.right);
        }
        arguments.name_space = rule.right.starts_with('/') ? rule.right : "/" + rule.right;
    } else if (rule.left == "__node" || rule.left == "__name") {
        if (!is_ros_word(rule.right)) {
            throw UsageError("--ros-args: '" + word + "': expected a name of letters, digits and _");
        }
        arguments.node = rule.right;
    } else {
        expect_name(word, rule.left);
        expect_name(word, rule.right);
        arguments.remappings.emplace_back(rule.left, rule.right);
    }
}

bool truth_in(const std::string& word, const std::string& text) {
    if (text == "true" || text == "True") {
        return true;
    }
    if (text == "false" || text == "False") {
        return false;
    }
    throw UsageError("--ros-args: '" + word + "': expected true or false");
}

double tolerance_in(const std::string& word, const std::string& text) {
    double value_s = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value_s);
    if (fault != std::errc{} || end != text.data() + text.size() || !(value_s >= 0.0) ||
        value_s > longest_tolerance_s) {
        throw UsageError("--ros-args: '" + word + "': expected seconds from 0 to 10");
    }
    return value_s;
}

void take_parameter(RosArguments& arguments, const std::string& word) {
    const Assignment rule = assignment_in(word, arguments.node, "NAME:=VALUE, such as use_sim_time:=true");
    if (!rule.is_for_this_node) {
        return;
    }
    if (rule.left == "use_sim_time") {
        arguments.use_sim_time = truth_in(word, rule.right);
    } else if (rule.left == "transform_tolerance") {
        arguments.transform_tolerance_s = tolerance_in(word, rule.right);
    } else {
        throw UsageError("--ros-args: '" + word +
                         "': there is no such parameter; expected use_sim_time or transform_tolerance");
    }
}

std::string absolute_name(const RosArguments& arguments, const std::string& name) {
    if (name.starts_with('/')) {
        return name;
    }
    const std::string base = arguments.name_space == "/" ? "" : arguments.name_space;
    return name.starts_with("~/") ? base + "/" + arguments.node + name.substr(1) : base + "/" + name;
}

}  // namespace

RosArguments parse_ros_arguments(const std::vector<std::string>& words) {
    RosArguments arguments;
    for (std::size_t place = 0; place < words.size(); ++place) {
        const std::string& word = words[place];
        const bool remaps = word == "-r" || word == "--remap";
        if (!remaps && word != "-p" && word != "--param") {
            throw UsageError("--ros-args: '" + word +
                             "': expected -r FROM:=TO (another name for a topic, __node or __ns), or -p NAME:=VALUE");
        }
        if (++place == words.size()) {
            throw UsageError("--ros-args: " + word + ": expected " + (remaps ? "FROM:=TO" : "NAME:=VALUE") +
                             " after it");
        }
        remaps ? take_remapping(arguments, words[place]) : take_parameter(arguments, words[place]);
    }
    return arguments;
}

std::string resolved_topic(const RosArguments& arguments, const std::string& name) {
    const std::string absolute = absolute_name(arguments, name);
    for (const auto& [from, to] : arguments.remappings) {
        if (absolute_name(arguments, from) == absolute) {
            return absolute_name(arguments, to);
        }
    }
    return absolute;
}

}  // namespace ddtool
