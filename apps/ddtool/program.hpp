#pragma once

#include "command.hpp"

namespace ddtool {

/// Reads the command line, with the options every command shares (--log-level, --quiet), and runs the chosen command.
/// Throws UsageError, with the nearest known words, for a command line that makes no sense; --help and --version print
/// on stdout and are done.
ExitCode run_program(const CommandTable& commands, int argc, const char* const* argv);

}  // namespace ddtool
