#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "logs/stream/log_inventory.hpp"
#include "logs/stream/log_use.hpp"

namespace ddtool {

/// What is wrong with a log: a count, and the first few in words.
struct LogDamage {
    static constexpr std::size_t max_told = 5;

    std::size_t problems = 0;
    std::uint64_t bytes_lost = 0;
    std::vector<std::string> first;

    /// Must not outlive the damage.
    LogProblemHandler handler();
};

struct LogInfo {
    LogInventory inventory;
    std::optional<LogUse> use;  ///< none: `unusable` says why
    std::string unusable;
    LogDamage damage;
};

Json info_json(const std::string& file, const LogInfo& info);
std::string info_text(const std::string& file, const LogInfo& info);

}  // namespace ddtool
