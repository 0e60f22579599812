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

/// One topic of a log, whether it is of use here or not; in a CARMEN log, one kind of line.
struct TopicInventory {
    std::string topic;
    std::string type;      ///< of its messages, as the log names it; empty in a CARMEN log
    std::string encoding;  ///< of its messages: "cdr", "ros1", ...
    std::size_t messages = 0;
    std::int64_t first_ns = 0;     ///< least time of recording
    std::int64_t last_ns = 0;      ///< greatest
    std::set<std::string> frames;  ///< "laser", "odom -> base", where the type is one that is read

    /// Messages a second between the first and the last; NaN where there are not two, or all have one time.
    [[nodiscard]] double rate_hz() const;
};

struct LogInventory {
    std::string format;                  ///< name_of() its container
    std::vector<TopicInventory> topics;  ///< by name

    [[nodiscard]] std::size_t messages() const;
    /// Least and greatest time of recording, of topics that have one; 0 without any.
    [[nodiscard]] std::int64_t first_ns() const;
    [[nodiscard]] std::int64_t last_ns() const;
    [[nodiscard]] double duration_s() const;
};

/// Counts the messages of a log of any kind to its end. Memory does not grow with the log. `on_progress` is told the
/// share read. Throws Error as container_of() and the readers do.
LogInventory take_inventory(const std::filesystem::path& path, LogProblemHandler on_problem,
                            const std::function<void(double)>& on_progress);

}  // namespace ddtool
