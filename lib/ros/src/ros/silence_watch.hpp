#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace ddtool {

/// Notices where topics that are published all the time fall silent, and when they come back. A topic is silent after
/// two seconds and ten of its usual intervals. heard() may be called by any thread, the others by one.
class SilenceWatch {
public:
    /// Returns the number of the topic.
    std::size_t add_topic(std::string name);
    /// Times in nanoseconds of the steady clock.
    void heard(std::size_t topic, std::int64_t now_ns);

    struct Finding {
        std::string topic;
        double silent_s = 0.0;
        bool is_back = false;
    };
    /// What has changed since the last call; call it until it finds nothing.
    std::optional<Finding> look(std::int64_t now_ns);
    /// How often a topic fell silent.
    [[nodiscard]] std::size_t silences() const;
    /// The topics on which nothing has ever come.
    [[nodiscard]] std::vector<std::string> never_heard() const;
    /// Whether a topic is silent now.
    [[nodiscard]] bool is_silent(std::size_t topic) const;

private:
    struct Topic {
        std::string name;
        std::int64_t last_ns = 0;  ///< 0: it was never heard
        double interval_ns = 0.0;  ///< usual; 0 before the second message
        bool is_silent = false;
        std::optional<double> was_silent_s;  ///< it is back, which nobody has been told
    };

    mutable std::mutex mutex_;
    std::deque<Topic> topics_;
    std::size_t silences_ = 0;
};

}  // namespace ddtool
