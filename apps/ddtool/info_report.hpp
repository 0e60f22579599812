#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "logs/stream/log_inventory.hpp"
#include "logs/stream/log_use.hpp"

namespace ddtool {

/// The problems of a log: their number, and the texts of the first few.
struct LogDamage {
    static constexpr std::size_t max_told = 5;

    std::size_t problems = 0;
    std::uint64_t bytes_lost = 0;
    std::vector<std::string> first;

    /// A handler that adds problems to this object. It must not outlive the object.
    LogProblemHandler handler();
};

struct LogInfo {
    LogInventory inventory;
    std::optional<LogUse> use;  ///< empty if the log cannot be used; `unusable` then says why
    std::string unusable;
    std::string options;  ///< the options for logs that were given, as log_options_text() writes them
    LogDamage damage;
};

Json info_json(const std::string& file, const LogInfo& info);
std::string info_text(const std::string& file, const LogInfo& info);

}  // namespace ddtool
