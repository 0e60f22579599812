#include "system/log.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr std::array<std::pair<const char*, LogLevel>, 4> level_names{
    {{"debug", LogLevel::debug}, {"info", LogLevel::info}, {"warning", LogLevel::warning}, {"error", LogLevel::error}}};

spdlog::level::level_enum spdlog_level(LogLevel level) {
    switch (level) {
        case LogLevel::debug:
            return spdlog::level::debug;
        case LogLevel::info:
            return spdlog::level::info;
        case LogLevel::warning:
            return spdlog::level::warn;
        case LogLevel::error:
            break;
    }
    return spdlog::level::err;
}

std::unique_ptr<spdlog::logger> make_logger() {
    const char* no_color = std::getenv("NO_COLOR");
    const bool plain = no_color != nullptr && *no_color != '\0';
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>(plain ? spdlog::color_mode::never
                                                                            : spdlog::color_mode::automatic);
    auto logger = std::make_unique<spdlog::logger>("ddtool", std::move(sink));
    // On a terminal, a progress line may be in the way, so it is erased first.
    const std::string wipe = ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
    logger->set_pattern(wipe + "ddtool: %^%l:%$ %v");
    return logger;
}

spdlog::logger& logger() {
    static const std::unique_ptr<spdlog::logger> the_logger = make_logger();
    return *the_logger;
}

std::function<void(LogLevel, const std::string&)>& log_taker() {
    static std::function<void(LogLevel, const std::string&)> taker;
    return taker;
}

void write_line(LogLevel level, const std::string& line) {
    if (!log_taker()) {
        logger().log(spdlog_level(level), "{}", line);  // not the format itself, because it may contain braces
    } else if (log_shows(level)) {
        log_taker()(level, line);
    }
}

}  // namespace

void set_log_level(LogLevel level) { logger().set_level(spdlog_level(level)); }

bool log_shows(LogLevel level) { return logger().should_log(spdlog_level(level)); }

LogLevel log_level_named(const std::string& name) {
    for (const auto& [known, level] : level_names) {
        if (name == known) {
            return level;
        }
    }
    throw UsageError("--log-level '" + name + "': expected debug, info, warning or error");
}

void send_log_to(std::function<void(LogLevel level, const std::string& line)> taker) { log_taker() = std::move(taker); }

void log_debug(const std::string& line) { write_line(LogLevel::debug, line); }
void log_info(const std::string& line) { write_line(LogLevel::info, line); }
void log_warning(const std::string& line) { write_line(LogLevel::warning, line); }
void log_error(const std::string& line) { write_line(LogLevel::error, line); }

}  // namespace ddtool
