#include <iostream>
#include <memory>
#include <utility>

#include "commands.hpp"
#include "info_report.hpp"
#include "log_options.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

struct InfoRequest {
    std::string log;
    bool as_json = false;
};

/// Progress for one half of the work: counting the messages takes about as long as reading them as a run does.
std::function<void(double)> half(Progress& progress, double before) {
    return [&progress, before](double share) { progress.update(before + 0.5 * share, 1); };
}

ExitCode describe_log(const InfoRequest& request, const Json& settings) {
    LogInfo info;
    Progress progress("info", "log");
    try {
        const auto log = open_log(request.log, log_options(settings.at("log")), info.damage.handler());
        info.use = use_of(*log, half(progress, 0.0));
        if (std::string reason = why_unusable(info.use->summary, info.use->returns); !reason.empty()) {
            throw Error(std::move(reason));
        }
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) {
        info.unusable = error.what();
        info.use.reset();
    }
    // Where the log cannot be used, the count below reads the whole of it and reports the damage of its container
    // again, but not that of its messages.
    const LogDamage found_first = info.damage;
    info.damage = info.use ? found_first : LogDamage{};
    const LogProblemHandler told_already = [](const LogProblem&) {};
    info.inventory = take_inventory(request.log, info.use ? told_already : info.damage.handler(), half(progress, 0.5));
    if (found_first.problems > info.damage.problems) {
        info.damage = found_first;
    }
    info.options = log_options_text(settings.at("log"));
    std::cout << (request.as_json ? info_json(request.log, info).dump(2) + "\n" : info_text(request.log, info));
    return info.damage.problems == 0 ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace

Command info_command() {
    const auto request = std::make_shared<InfoRequest>();
    std::vector<Option> options{
        {"FILE", &request->log, log_file_help, "FILE", Presence::required},
    };
    append_log_options(options);
    options.push_back({"--json", &request->as_json, "Print JSON instead of tables"});
    return {.name = "info",
            .summary = "What is in a log, and what a run would use of it",
            .example = "ddtool info run.bag",
            .settings = {{"log", default_log_settings()}},
            .options = std::move(options),
            .run = [request](const Json& settings) { return describe_log(*request, settings); }};
}

}  // namespace ddtool
