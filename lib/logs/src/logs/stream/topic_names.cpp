#include "logs/stream/topic_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string_view>
#include <vector>

#include "base/text.hpp"

namespace ddtool {
namespace {

std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (std::isalnum(code) != 0) {
            words.back() += static_cast<char>(std::tolower(code));
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    return words;
}

bool any_word(const std::string& name, const std::function<bool(const std::string&)>& condition) {
    const std::vector<std::string> words = words_of(name);
    return std::any_of(words.begin(), words.end(), condition);
}

}  // namespace

bool names_ground_truth(const std::string& name) {
    const std::vector<std::string> words = words_of(name);
    const auto ground = std::adjacent_find(words.begin(), words.end(), [](const std::string& a, const std::string& b) {
        return a == "ground" && b == "truth";
    });
    return ground != words.end() ||
           any_word(name, [](const std::string& word) { return word == "groundtruth" || word == "gt"; });
}

bool names_odometry(const std::string& name) {
    return any_word(name, [](const std::string& word) { return word.starts_with("odom"); });
}

bool names_no_measurement(const std::string& name) {
    constexpr std::array<std::string_view, 11> others{"cmd",      "command", "teleop",      "joy",  "goal", "target",
                                                      "setpoint", "desired", "initialpose", "amcl", "map"};
    return any_word(name, [&](const std::string& word) { return std::ranges::count(others, word) > 0; });
}

bool names_static(const std::string& name) {
    return any_word(name, [](const std::string& word) { return word == "static"; });
}

bool names_fixed_frame(const std::string& name) {
    return names_odometry(name) ||
           any_word(name, [](const std::string& word) { return word == "map" || word == "world" || word == "earth"; });
}

std::vector<std::string> topics_named(const std::string& option) {
    std::vector<std::string> topics;
    std::string_view rest = option;
    for (std::string_view topic = next_word(rest); !topic.empty(); topic = next_word(rest)) {
        topics.emplace_back(topic);
    }
    return topics;
}

std::string transform_namespace(const std::string& topic) {
    const std::size_t slash = topic.rfind('/');
    if (slash == std::string::npos) {
        return "";
    }
    const std::string last = topic.substr(slash + 1);
    return last == "tf" || last == "tf_static" ? topic.substr(0, slash) : "";
}

bool is_in_namespace(const std::string& topic, const std::string& name) {
    return name.empty() || topic.starts_with(name + "/");
}

}  // namespace ddtool
