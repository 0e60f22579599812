#pragma once

#include <string>

namespace ddtool {

/// The one home of diagnostics: a line each on stderr, "ddtool: warning: ...", in colour on a terminal unless NO_COLOR
/// is set (https://no-color.org). Results go to stdout, and what ends a command is an Error instead.
enum class LogLevel : int { debug, info, warning, error };

/// Lines below `level` are dropped. The level at start is info.
void set_log_level(LogLevel level);
/// Whether lines of this level are written; progress shows at info.
bool log_shows(LogLevel level);
/// A level by its name, "debug", "info", "warning" or "error". Throws UsageError for another.
LogLevel log_level_named(const std::string& name);

void log_debug(const std::string& line);
void log_info(const std::string& line);
void log_warning(const std::string& line);
void log_error(const std::string& line);

}  // namespace ddtool
