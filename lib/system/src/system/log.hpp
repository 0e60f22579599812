#pragma once

#include <functional>
#include <string>

namespace ddtool {

/// Diagnostics: each is one line on stderr, "ddtool: warning: ...", in colour on a terminal unless NO_COLOR is set
/// (https://no-color.org). Results go to stdout instead, and a failure that ends a command is thrown as an Error. The
/// functions may be called from any thread.
enum class LogLevel : int { debug, info, warning, error };

/// Lines below `level` are dropped. The level at start is info.
void set_log_level(LogLevel level);
/// Whether lines of this level are written. Progress lines are shown if info is.
bool log_shows(LogLevel level);
/// Returns the level named "debug", "info", "warning" or "error". Throws UsageError for any other name.
LogLevel log_level_named(const std::string& name);

/// Hands every line that is shown to `taker`, in the place of stderr, on the thread that it comes from. For a host with
/// a log of its own. Must not be called while other threads write lines.
void send_log_to(std::function<void(LogLevel level, const std::string& line)> taker);

void log_debug(const std::string& line);
void log_info(const std::string& line);
void log_warning(const std::string& line);
void log_error(const std::string& line);

}  // namespace ddtool
