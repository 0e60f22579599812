#include "program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "system/log.hpp"
#include "system/setting_rows.hpp"
#include "version.hpp"

// This is the only file that includes CLI11, which takes longer to compile than all commands together.
namespace ddtool {
namespace {

std::string type_name(const Json& value) {
    if (value.is_number_integer()) {
        return "INT";
    }
    if (value.is_number()) {
        return "NUMBER";
    }
    return value.is_array() ? "LIST" : "TEXT";
}

/// The value as it is written on a command line: nothing for null, and a list without its brackets.
std::string bare(const Json& value) {
    const std::string text = value.is_null() ? "" : value.dump();
    return value.is_array() ? text.substr(1, text.size() - 2) : text;
}

/// A command as CLI11 parses it. CLI11 keeps pointers into this object, so it must not be copied or moved.
class ParsedCommand {
public:
    ParsedCommand(CLI::App& program, const Command& command);
    ParsedCommand(const ParsedCommand&) = delete;
    ParsedCommand& operator=(const ParsedCommand&) = delete;
    ~ParsedCommand() = default;

    [[nodiscard]] bool chosen() const { return app_.parsed(); }
    ExitCode run() const;

private:
    struct AssignedValue {
        std::string option;
        std::string path;
        std::string text;
    };

    struct AssignedGroup {
        std::string option;
        std::string name;
        Json settings;
    };

    void declare(const Option& option);
    CLI::Option* declare_setting(const Option& option, const std::string& path);
    CLI::Option* declare_groups(const Option& option, const NamedSettings& settings);
    /// Declares --config and --set.
    void declare_files_and_assignments();
    /// Merges the chosen groups of settings, --config, --set and the options that stand for settings, in this order.
    [[nodiscard]] Json with_all_changes(Json settings) const;
    [[nodiscard]] Json effective_settings() const;

    const Command& command_;
    CLI::App& app_;
    std::vector<std::string> config_files_;
    std::vector<std::string> assignments_;
    std::vector<AssignedValue> assigned_values_;
    std::vector<AssignedGroup> assigned_groups_;
    std::vector<std::pair<const CLI::Option*, bool*>> asked_for_;
};

ParsedCommand::ParsedCommand(CLI::App& program, const Command& command)
    : command_(command), app_(*program.add_subcommand(command.name, command.summary)) {
    app_.footer("Example:\n  " + command.example);
    for (const Option& option : command.options) {
        declare(option);
    }
    declare_files_and_assignments();
}

CLI::Option* ParsedCommand::declare_setting(const Option& option, const std::string& path) {
    const Json default_value = setting_at(command_.settings, path);
    const auto assign = [this, name = option.name, path](const std::string& text) {
        assigned_values_.push_back({name, path, text});
    };
    if (default_value.is_boolean()) {
        return app_.add_flag_function(
            option.name + ",!--no-" + option.name.substr(2),
            [assign](std::int64_t count) { assign(count > 0 ? "true" : "false"); }, option.help);
    }
    return app_.add_option_function<std::string>(option.name, assign, option.help)
        ->type_name(type_name(default_value))
        ->default_str(default_value.is_string() ? default_value.get<std::string>() : bare(default_value));
}

CLI::Option* ParsedCommand::declare_groups(const Option& option, const NamedSettings& settings) {
    const auto assign = [this, name = option.name, settings](const std::string& chosen) {
        const auto group = std::ranges::find(settings.groups, chosen, [](const auto& each) { return each.first; });
        if (group == settings.groups.end()) {
            std::vector<std::string> names;
            for (const auto& each : settings.groups) {
                names.push_back(each.first);
            }
            throw UsageError(name + ": expected " + joined(names) + ", not '" + chosen + "'");
        }
        *settings.chosen = chosen;
        assigned_groups_.push_back({name, chosen, group->second});
    };
    return app_.add_option_function<std::string>(option.name, assign, option.help)->default_str(*settings.chosen);
}

void ParsedCommand::declare(const Option& option) {
    const auto declare_value = [&](const auto& value) -> CLI::Option* {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, SettingPath>) {
            return declare_setting(option, value.path);
        } else if constexpr (std::is_same_v<Value, NamedSettings>) {
            return declare_groups(option, value);
        } else if constexpr (std::is_same_v<Value, bool*>) {
            return app_.add_flag(option.name, *value, option.help);
        } else if constexpr (std::is_same_v<Value, std::vector<std::string>*>) {
            return app_.add_option(option.name, *value, option.help);
        } else {
            return app_.add_option(option.name, *value, option.help)->capture_default_str();
        }
    };
    CLI::Option* const declared = std::visit(declare_value, option.value);
    declared->required(option.presence == Presence::required);
    if (!option.type.empty()) {
        declared->type_name(option.type);
    }
    if (!option.alone.empty()) {
        declared->expected(0, 1)->default_str(option.alone);
    }
    if (!option.needs.empty()) {
        declared->needs(option.needs);
    }
    if (!option.excludes.empty()) {
        declared->excludes(option.excludes);
    }
    if (option.given != nullptr) {
        asked_for_.emplace_back(declared, option.given);
    }
    if (option.takes_rest) {
        declared->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
}

void ParsedCommand::declare_files_and_assignments() {
    const auto repeated = [this](const char* name, std::vector<std::string>& values, const char* help,
                                 const char* type) {
        app_.add_option(name, values, help)
            ->type_name(type)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    repeated("--config", config_files_, "JSON file of settings; may be repeated, later ones win", "FILE.json");
    repeated("--set", assignments_, "One setting, e.g. --set filter.particles=60; may be repeated", "PATH=VALUE");
}

Json ParsedCommand::with_all_changes(Json settings) const {
    for (const auto& [option, name, group] : assigned_groups_) {
        merge_settings(settings, group, option + " " + name);
    }
    for (const std::string& file : config_files_) {
        merge_settings_file(settings, file);
    }
    for (const std::string& assignment : assignments_) {
        merge_assignment(settings, assignment);
    }
    for (const auto& [option, path, text] : assigned_values_) {
        merge_setting(settings, path, text, option);
    }
    return settings;
}

Json ParsedCommand::effective_settings() const {
    Json settings = with_all_changes(command_.settings);
    const std::optional<BuiltinPlan>& plan = command_.plan;
    if (!plan || !config_files_.empty() || !plan->lacking(settings)) {
        return settings;
    }
    log_info("no --config: the plan is " + plan->name + ", which is inside the program");
    settings = command_.settings;
    merge_settings(settings, parse_json(plan->text, plan->name, /*comments=*/true), plan->name);
    return with_all_changes(std::move(settings));
}

ExitCode ParsedCommand::run() const {
    for (const auto& [option, given] : asked_for_) {
        *given = option->count() > 0;
    }
    return command_.run(effective_settings());
}

/// The whole program as CLI11 parses it.
struct ParsedProgram {
    explicit ParsedProgram(const CommandTable& table);

    CLI::App app{"Lidar SLAM that sees when it is degenerate, and acts on it", "ddtool"};
    std::vector<std::unique_ptr<ParsedCommand>> commands;
};

void add_shared_options(CLI::App& program) {
    program.set_version_flag("--version", version_text, "Print the version, the commit and those of the libraries");
    program
        .add_option_function<std::string>(
            "--log-level", [](const std::string& name) { set_log_level(log_level_named(name)); },
            "Least of what is written on stderr")
        ->type_name("debug|info|warning|error")
        ->default_str("info");
    program.add_flag_callback(
        "--quiet", [] { set_log_level(LogLevel::error); }, "Only errors on stderr: --log-level error");
    program.footer("ddtool COMMAND --help shows the options of a command and an example.");
}

ParsedProgram::ParsedProgram(const CommandTable& table) {
    add_shared_options(app);
    app.require_subcommand(0, 1);
    app.fallthrough();  // shared options may also stand behind the command
    for (const Command& command : table) {
        commands.push_back(std::make_unique<ParsedCommand>(app, command));
    }
    // Collects unknown words, for which we then suggest the nearest known ones; CLI11 would only name them. It is set
    // last because commands inherit it when they are added, and it shall hold for the program alone.
    app.allow_extras();
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    return known.empty() ? "" : "; did you mean: " + joined(nearest_words(word, known)) + "?";
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        const std::vector<std::string>& own = option->get_lnames();
        std::transform(own.begin(), own.end(), std::back_inserter(names), [](const auto& name) { return "--" + name; });
    }
    return names;
}

[[noreturn]] void fail_unexpected(const CLI::App& program, const std::string& word) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    const CLI::App& app = chosen.empty() ? program : *chosen.front();
    if (word.starts_with("-")) {
        throw UsageError("unknown option '" + word + "'" +
                         did_you_mean(word.substr(0, word.find('=')), option_names(app)));
    }
    if (!chosen.empty()) {
        throw UsageError(app.get_name() + ": unexpected argument '" + word + "'");
    }
    std::vector<std::string> names;
    for (const CLI::App* command : commands_of(program)) {
        names.push_back(command->get_name());
    }
    throw UsageError("unknown command '" + word + "'" + did_you_mean(word, names));
}

HelpText text_of(const CLI::App& app) {
    HelpText text{.name = app.get_name(), .summary = app.get_description(), .footer = app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        text.options.push_back({.names = option->get_name(option->get_positional(), true),
                                .long_names = option->get_lnames(),
                                .positional = option->get_positional(),
                                .takes_value = option->get_items_expected_max() > 0,
                                .type = option->get_type_name(),
                                .default_value = option->get_default_str(),
                                .help = option->get_description()});
    }
    for (const CLI::App* command : commands_of(app)) {
        text.commands.push_back(text_of(*command));
    }
    return text;
}

}  // namespace

std::string choices(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) {
        all += (all.empty() ? "" : "|") + word;
    }
    return all;
}

namespace {

/// The arguments with each word after an option that takes the rest tied to it, as --OPTION=WORD, because CLI11 would
/// take the words for options of the command.
std::vector<std::string> with_rest_tied(const CommandTable& commands, int argc, const char* const* argv) {
    const auto takes_rest = [&](const std::string& word) {
        return std::ranges::any_of(commands, [&](const Command& command) {
            return std::ranges::any_of(command.options,
                                       [&](const Option& option) { return option.takes_rest && option.name == word; });
        });
    };
    std::vector<std::string> words;
    std::string option;
    for (int place = 1; place < argc; ++place) {
        const std::string word = argv[place];
        if (option.empty() && takes_rest(word)) {
            option = word;
        } else if (!option.empty() && word == "--") {
            option.clear();
        } else {
            words.push_back(option.empty() ? word : option + "=" + word);
        }
    }
    std::ranges::reverse(words);  // the order in which CLI11 takes them
    return words;
}

}  // namespace

HelpText help_text(const CommandTable& commands) { return text_of(ParsedProgram(commands).app); }

ExitCode run_program(const CommandTable& commands, int argc, const char* const* argv) {
    ParsedProgram program(commands);
    try {
        program.app.parse(with_rest_tied(commands, argc, argv));
    } catch (const CLI::Success& help_or_version) {
        program.app.exit(help_or_version);
        return ExitCode::done;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (const std::vector<std::string> unknown = program.app.remaining(); !unknown.empty()) {
        fail_unexpected(program.app, unknown.front());
    }
    const auto chosen = std::find_if(program.commands.begin(), program.commands.end(),
                                     [](const auto& command) { return command->chosen(); });
    if (chosen == program.commands.end()) {
        throw UsageError("expected a command; ddtool --help lists them");
    }
    return (*chosen)->run();
}

}  // namespace ddtool
