#include <iostream>
#include <memory>

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

/// Throws Error if the frames hold nothing that a map could be made of.
void expect_returns(const LogUse& use) {
    if (use.summary.scans == 0) {
        throw Error("none of its scans can be used" + (use.summary.first_problems.empty()
                                                           ? ""
                                                           : "; the first problem: " + use.summary.first_problems[0]));
    }
    if (use.returns == 0) {
        throw Error("no beam of its " + std::to_string(use.summary.scans) + " scans has a return");
    }
}

ExitCode describe_log(const InfoRequest& request, const Json& settings) {
    LogInfo info;
    Progress progress("info", "log");
    try {
        const auto log = open_log(request.log, log_options(settings.at("log")), info.damage.handler());
        info.use = use_of(*log, half(progress, 0.0));
        expect_returns(*info.use);
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) {
        info.unusable = error.what();
        info.use.reset();
        info.damage = {};  // the count below reads the whole log and reports the damage again
    }
    const LogProblemHandler told_already = [](const LogProblem&) {};
    info.inventory = take_inventory(request.log, info.use ? told_already : info.damage.handler(), half(progress, 0.5));
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
