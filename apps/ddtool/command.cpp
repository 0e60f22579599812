#include "command.hpp"

#include <cstdint>
#include <utility>

#include "system/setting_rows.hpp"

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

/// As it may be written on a command line: no default for null, a list without its brackets.
std::string bare(const Json& value) {
    const std::string text = value.is_null() ? "" : value.dump();
    return value.is_array() ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

Command::Command(std::string name, std::string summary, std::string example)
    : name_(std::move(name)), summary_(std::move(summary)), example_(std::move(example)) {}

void Command::declare(CLI::App& program) {
    app_ = program.add_subcommand(name_, summary_);
    app_->footer("Example:\n  " + example_);
    add_options(*app_);
    app_->add_option("--config", config_files_, "JSON file of settings; may be repeated, later ones win")
        ->type_name("FILE.json")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app_->add_option("--set", assignments_, "One setting, e.g. --set filter.particles=60; may be repeated")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

ExitCode Command::execute() { return run(effective_settings()); }

CLI::Option* Command::bind_option(CLI::App& app, const std::string& option, const std::string& path,
                                  const std::string& help) {
    const Json default_value = setting_at(default_settings(), path);
    const auto bind = [this, option, path](const std::string& text) { bound_values_.push_back({option, path, text}); };
    if (default_value.is_boolean()) {
        return app.add_flag_function(
            option + ",!--no-" + option.substr(2), [bind](std::int64_t count) { bind(count > 0 ? "true" : "false"); },
            help);
    }
    return app.add_option_function<std::string>(option, bind, help)
        ->type_name(type_name(default_value))
        ->default_str(default_value.is_string() ? default_value.get<std::string>() : bare(default_value));
}

std::string Command::choices(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) {
        all += (all.empty() ? "" : "|") + word;
    }
    return all;
}

Json Command::effective_settings() const {
    Json settings = default_settings();
    for (const std::string& file : config_files_) {
        merge_settings_file(settings, file);
    }
    for (const std::string& assignment : assignments_) {
        merge_assignment(settings, assignment);
    }
    for (const auto& [option, path, text] : bound_values_) {
        merge_setting(settings, path, text, option);
    }
    return settings;
}

}  // namespace ddtool
