#include "command.hpp"

#include <utility>

namespace ddtool {

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

void Command::bind_option(CLI::App& app, const std::string& option, const std::string& path, const std::string& help) {
    app.add_option_function<std::string>(
        option, [this, path](const std::string& value) { bound_values_[path] = value; }, help);
}

Json Command::effective_settings() const {
    Json settings = default_settings();
    for (const std::string& file : config_files_) {
        merge_settings_file(settings, file);
    }
    for (const std::string& assignment : assignments_) {
        merge_setting(settings, assignment);
    }
    for (const auto& [path, value] : bound_values_) {
        merge_setting(settings, path + "=" + value);
    }
    return settings;
}

}  // namespace ddtool
