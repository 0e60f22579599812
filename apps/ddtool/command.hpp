#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

/// One sub-command of ddtool. A file each; main holds the table of them.
class Command {
public:
    Command(std::string name, std::string summary, std::string example);
    virtual ~Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    /// Adds the sub-command with its own options and those every command has (--config, --set).
    void declare(CLI::App& program);
    [[nodiscard]] bool chosen() const { return app_->parsed(); }
    /// Merges defaults, --config, --set and bound options, in that order, then runs.
    ExitCode execute();

protected:
    virtual void add_options(CLI::App& app) = 0;
    /// Every setting the command knows, with its default.
    [[nodiscard]] virtual Json default_settings() const { return Json::object(); }
    virtual ExitCode run(const Json& settings) = 0;

    /// A command-line option that is short for --set path=VALUE; where the default is a boolean, a flag with its
    /// --no- twin. Help shows the default. Throws std::out_of_range for a path that default_settings() lacks.
    /// Returns the option, whose type_name tells the values: a|b for a choice (completion.hpp).
    CLI::Option* bind_option(CLI::App& app, const std::string& option, const std::string& path,
                             const std::string& help);

    /// The type name of an option whose value is one of these.
    [[nodiscard]] static std::string choices(const std::vector<std::string>& words);

private:
    struct BoundValue {
        std::string option;
        std::string path;
        std::string text;
    };

    [[nodiscard]] Json effective_settings() const;

    std::string name_;
    std::string summary_;
    std::string example_;
    CLI::App* app_ = nullptr;
    std::vector<std::string> config_files_;
    std::vector<std::string> assignments_;
    std::vector<BoundValue> bound_values_;
};

using CommandTable = std::vector<std::unique_ptr<Command>>;

}  // namespace ddtool
