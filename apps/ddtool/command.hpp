#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

/// The setting that an option stands for: the option is short for --set PATH=VALUE.
struct SettingPath {
    std::string path;  ///< keys joined by dots; Command::settings must contain it
};

/// Groups of settings, each with a name. The option's value is the name of one, which is merged into the settings
/// ahead of --config, --set and the options that stand for settings.
struct NamedSettings {
    std::vector<std::pair<std::string, Json>> groups;
    std::string* chosen = nullptr;  ///< its value before parsing is the group that Command::settings agree with
};

/// Where the value of an option goes: to a setting, to the choice of a group of settings, or to a variable, whose value
/// before parsing is the default. A bool variable makes the option a flag, and so does a setting of type bool, which
/// also gets the opposite flag --no-NAME. A vector takes one value or several.
using OptionValue = std::variant<SettingPath, NamedSettings, bool*, std::string*, std::vector<std::string>*,
                                 std::size_t*, std::uint16_t*, double*>;

enum class Presence { optional, required };

/// One option of a command. --help shows its default.
struct Option {
    std::string name;  ///< such as "--out"; without dashes it is a positional argument
    OptionValue value;
    std::string help;
    /// the type of the value in --help, from which completion follows (completion_command.cpp); empty for the
    /// variable's type
    std::string type = {};
    Presence presence = Presence::optional;
    /// the value if the option is given without one; if this is empty, the option requires a value
    std::string alone = {};
    std::string needs = {};     ///< an option declared before this one, which must be given, too
    std::string excludes = {};  ///< an option declared before this one, which must not be given as well
    bool* given = nullptr;      ///< set to true if the option is given
    bool takes_rest = false;    ///< all words after the option are its values, up to "--", if there is one
};

/// Settings inside the program for a command that is given no plan of its own. --set and options are merged into them.
struct BuiltinPlan {
    std::string name;       ///< names the plan in messages
    std::string_view text;  ///< JSON with comments, which changes Command::settings
    /// Returns whether the settings that the user gave lack a plan. It is called only if there is no --config.
    std::function<bool(const Json& settings)> lacking;
};

/// One sub-command of ddtool: a row of the table in commands.hpp. The options that every command with settings takes
/// (--config, --set) are not listed here.
struct Command {
    std::string name;
    std::string summary;
    std::string example;
    Json settings = Json::object();  ///< every setting of the command, with its default
    std::optional<BuiltinPlan> plan = {};
    std::vector<Option> options;
    /// Called with the settings that result from --config, --set and the options that stand for settings.
    std::function<ExitCode(const Json& settings)> run;
};

using CommandTable = std::vector<Command>;

/// The type text of an option whose value must be one of these words.
std::string choices(const std::vector<std::string>& words);

}  // namespace ddtool
