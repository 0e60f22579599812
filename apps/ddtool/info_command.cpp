#include "info_command.hpp"

#include <iostream>

#include "info_report.hpp"
#include "log_options.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

/// Half of the work is the count, half the reading as a run does it.
std::function<void(double)> half(Progress& progress, double before) {
    return [&progress, before](double share) { progress.update(before + 0.5 * share, 1); };
}

}  // namespace

InfoCommand::InfoCommand()
    : Command("info", "What is in a log, and what a run would use of it", "ddtool info run.bag") {}

void InfoCommand::add_options(CLI::App& app) {
    app.add_option("FILE", log_file_, log_file_help)->type_name("FILE")->required();
    for (const auto& [option, path, help] : log_option_table) {
        bind_option(app, option, path, help);
    }
    app.add_flag("--json", as_json_, "Print JSON instead of tables");
}

Json InfoCommand::default_settings() const { return {{"log", default_log_settings()}}; }

ExitCode InfoCommand::run(const Json& settings) {
    LogInfo info;
    Progress progress("info", "log");
    try {
        const auto log = open_log(log_file_, log_options(settings.at("log")), info.damage.handler());
        info.use = use_of(*log, half(progress, 0.0));
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) {
        info.unusable = error.what();
        info.damage = {};  // the count, which reads all, tells it again
    }
    const LogProblemHandler told_already = [](const LogProblem&) {};
    info.inventory = take_inventory(log_file_, info.use ? told_already : info.damage.handler(), half(progress, 0.5));
    std::cout << (as_json_ ? info_json(log_file_, info).dump(2) + "\n" : info_text(log_file_, info));
    return info.damage.problems == 0 ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool
