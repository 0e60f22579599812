#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"

namespace ddtool {

/// One topic of a log, whether ddtool uses it or not. In a CARMEN log it is one kind of line.
struct TopicInventory {
    std::string topic;
    std::string type;      ///< of its messages, as the log names it; empty in a CARMEN log
    std::string encoding;  ///< of its messages: "cdr", "ros1", ...
    std::size_t messages = 0;
    std::int64_t first_ns = 0;     ///< earliest time of recording
    std::int64_t last_ns = 0;      ///< latest time of recording
    std::set<std::string> frames;  ///< "laser", "odom -> base"; only of types that ddtool reads

    /// Messages per second between the first and the last; NaN if there are fewer than two, or if all have the same
    /// time.
    [[nodiscard]] double rate_hz() const;
};

struct LogInventory {
    std::string format;                  ///< name_of() its container
    std::vector<TopicInventory> topics;  ///< by name

    [[nodiscard]] std::size_t messages() const;
    /// The earliest and the latest time of recording, over all topics that have one; 0 if no topic has one.
    [[nodiscard]] std::int64_t first_ns() const;
    [[nodiscard]] std::int64_t last_ns() const;
    [[nodiscard]] double duration_s() const;
};

/// Counts the messages of a log of any format, up to its end. Memory does not grow with the log.
/// \param on_progress is called with the share read, 0..1
/// Throws Error as find_log() and the readers do.
LogInventory take_inventory(const std::filesystem::path& path, LogProblemHandler on_problem,
                            const std::function<void(double)>& on_progress);

}  // namespace ddtool
