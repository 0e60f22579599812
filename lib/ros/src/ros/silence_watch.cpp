#include "ros/silence_watch.hpp"

#include <algorithm>
#include <utility>

namespace ddtool {
namespace {

constexpr double least_silence_ns = 2e9;
constexpr double usual_intervals = 10.0;
constexpr double share_of_latest = 0.1;  ///< in the usual interval

}  // namespace

std::size_t SilenceWatch::add_topic(std::string name) {
    const std::lock_guard lock(mutex_);
    topics_.push_back({.name = std::move(name), .was_silent_s = {}});
    return topics_.size() - 1;
}

void SilenceWatch::heard(std::size_t topic, std::int64_t now_ns) {
    const std::lock_guard lock(mutex_);
    Topic& known = topics_[topic];
    const auto passed_ns = static_cast<double>(now_ns - known.last_ns);
    if (known.is_silent) {
        known.is_silent = false;
        known.was_silent_s = 1e-9 * passed_ns;
    } else if (known.last_ns != 0) {
        known.interval_ns = known.interval_ns == 0.0
                                ? passed_ns
                                : known.interval_ns + share_of_latest * (passed_ns - known.interval_ns);
    }
    known.last_ns = now_ns;
}

std::optional<SilenceWatch::Finding> SilenceWatch::look(std::int64_t now_ns) {
    const std::lock_guard lock(mutex_);
    for (Topic& topic : topics_) {
        if (topic.was_silent_s) {
            return Finding{topic.name, *std::exchange(topic.was_silent_s, std::nullopt), true};
        }
        const auto passed_ns = static_cast<double>(now_ns - topic.last_ns);
        if (!topic.is_silent && topic.interval_ns > 0.0 &&
            passed_ns > std::max(least_silence_ns, usual_intervals * topic.interval_ns)) {
            topic.is_silent = true;
            ++silences_;
            return Finding{topic.name, 1e-9 * passed_ns, false};
        }
    }
    return std::nullopt;
}

std::size_t SilenceWatch::silences() const {
    const std::lock_guard lock(mutex_);
    return silences_;
}

std::vector<std::string> SilenceWatch::never_heard() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names;
    for (const Topic& topic : topics_) {
        if (topic.last_ns == 0) {
            names.push_back(topic.name);
        }
    }
    return names;
}

bool SilenceWatch::is_silent(std::size_t topic) const {
    const std::lock_guard lock(mutex_);
    return topics_[topic].is_silent;
}

}  // namespace ddtool
