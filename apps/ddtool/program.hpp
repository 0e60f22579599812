#pragma once

#include <string>
#include <vector>

#include "command.hpp"

namespace ddtool {

/// Parses the command line, including the options that every command shares (--log-level, --quiet), and runs the chosen
/// command. Throws UsageError with the nearest known words if the command line is wrong. --help and --version print
/// their text on stdout and return ExitCode::done.
ExitCode run_program(const CommandTable& commands, int argc, const char* const* argv);

/// An option as --help shows it.
struct OptionText {
    std::string names;                    ///< all names, such as "-h,--help"
    std::vector<std::string> long_names;  ///< such as "help", without dashes; empty for a positional argument
    bool positional = false;
    bool takes_value = false;
    std::string type;  ///< the type of the value
    std::string default_value;
    std::string help;
};

/// The program or a command as --help shows it.
struct HelpText {
    std::string name;
    std::string summary;
    std::string footer;
    std::vector<OptionText> options = {};
    std::vector<HelpText> commands = {};  ///< the commands, if this is the program
};

HelpText help_text(const CommandTable& commands);

}  // namespace ddtool
