#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace ddtool {

/// Reads the command line, with the options every command shares (--log-level, --quiet), and runs the chosen command.
/// Throws UsageError, with the nearest known words, for a command line that makes no sense; --help and --version print
/// on stdout and are done.
ExitCode run_program(const CommandTable& commands, int argc, const char* const* argv);

/// An option as --help shows it.
struct OptionText {
    std::string names;                    ///< all of them, "-h,--help"
    std::vector<std::string> long_names;  ///< "help": without dashes, empty for an argument that goes by its place
    bool positional = false;
    bool takes_value = false;
    std::string type;  ///< of the value
    std::string default_value;
    std::string help;
};

/// The program, or a command, as --help shows it.
struct HelpText {
    std::string name;
    std::string summary;
    std::string footer;
    std::vector<OptionText> options = {};
    std::vector<HelpText> commands = {};  ///< of the program
};

HelpText help_text(const CommandTable& commands);

}  // namespace ddtool
