#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

/// The setting that an option is short for: the option is --set PATH=VALUE.
struct SettingPath {
    std::string path;  ///< keys with dots between them; Command::settings must have it
};

/// Where the value of an option goes: to a setting, or to a variable, which holds the default until then. A bool, and a
/// setting that is one, make a flag; the setting's has a twin, --no-NAME. A list takes one value or several.
using OptionValue =
    std::variant<SettingPath, bool*, std::string*, std::vector<std::string>*, std::size_t*, std::uint16_t*, double*>;

enum class Presence { optional, required };

/// One option of a command. Its default is shown by --help.
struct Option {
    std::string name;  ///< "--out"; without dashes an argument that goes by its place
    OptionValue value;
    std::string help;
    std::string type = {};  ///< of the value, for --help and completion (completion.hpp); empty: that of the variable
    Presence presence = Presence::optional;
    std::string alone = {};     ///< the value where the option is given without one; empty: it needs one
    std::string needs = {};     ///< an option above this one, without which this one makes no sense
    std::string excludes = {};  ///< an option above this one, beside which this one makes no sense
    bool* given = nullptr;      ///< becomes true where the option is given
};

/// One sub-command of ddtool: a row of the table in commands.hpp. What every command takes (--config, --set) is not
/// among its options.
struct Command {
    std::string name;
    std::string summary;
    std::string example;
    Json settings = Json::object();  ///< every setting it knows, with its default
    std::vector<Option> options;
    /// Gets the settings after --config, --set and the options that stand for some.
    std::function<ExitCode(const Json& settings)> run;
};

using CommandTable = std::vector<Command>;

/// The type of an option whose value is one of these.
std::string choices(const std::vector<std::string>& words);

}  // namespace ddtool
