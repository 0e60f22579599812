#include "slam_command.hpp"

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <iostream>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/process_usage.hpp"
#include "base/progress.hpp"
#include "log_options.hpp"
#include "results/run_folder.hpp"
#include "results/run_report.hpp"
#include "slam/settings_json.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;

void check_method(const std::string& method) {
    if (method != "gmapping") {
        throw UsageError("method: expected gmapping, not '" + method + "'");
    }
}

Json log_report(const std::string& file, const LogSummary& log) {
    return {{"file", file},
            {"format", log.format},
            {"scan_topic", log.scan_topic},
            {"odom_topic", log.odom_topic},
            {"ground_truth_topic", log.ground_truth_topic},
            {"scans", log.scans},
            {"odometry", log.odometry},
            {"ground_truth", log.ground_truth},
            {"problems", log.problems},
            {"bytes_lost", log.bytes_lost},
            {"assumptions", log.assumptions}};
}

Json version_report() {
    Json report = Json::object();
    for (const auto& [name, number] : versions()) {
        report[name] = number;
    }
    return report;
}

std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string formatted(const char* format, ...) {
    char text[256];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

/// What a person wants to know of a run, from its run.json.
std::string summary_text(const Json& report, const std::string& folder, const std::vector<std::string>& files) {
    const Json& run = report.at("run");
    const Json& cost = report.at("cost");
    std::string text = formatted("scans    %zu in %.0f s; %zu filter updates, %zu resamplings\n",
                                 run.at("scans").get<std::size_t>(), run.at("duration_s").get<double>(),
                                 run.at("updates").get<std::size_t>(), run.at("resamplings").get<std::size_t>()) +
                       formatted("map      %.1f m x %.1f m, path %.1f m\n", run.at("map").at("width_m").get<double>(),
                                 run.at("map").at("height_m").get<double>(), run.at("path_m").get<double>());
    if (run.contains("errors")) {
        text += formatted("error    %.3f m rmse against the ground truth (ATE)\n",
                          run.at("errors").at("ate_m").at("rmse").get<double>());
    }
    text += formatted("cost     %.1f s, %.1f s of CPU time, %.0f MB at most\n", cost.at("wall_s").get<double>(),
                      cost.at("cpu_s").get<double>(), 1e-6 * cost.at("peak_memory_bytes").get<double>());
    return text + "written  " + folder + ": " + joined(files) + "\n";
}

}  // namespace

SlamCommand::SlamCommand() : Command("slam", "Map and trajectory from a log", "ddtool slam --log run.mcap --out run") {}

void SlamCommand::add_options(CLI::App& app) {
    app.add_option("--log", log_file_, "The log: MCAP or CARMEN (also .gz, .bz2)")->type_name("FILE")->required();
    app.add_option("--out", folder_, "Folder for the results; created where it is not there")
        ->type_name("DIR")
        ->required();
    bind_option(app, "--method", "method", "gmapping: particle filter after Grisetti et al. 2007");
    bind_option(app, "--particles", "filter.particles", "Hypotheses, each with its own map");
    bind_option(app, "--seed", "filter.seed", "Of all chance: the same seed gives the same result");
    app.add_option("--threads", threads_, "0: every core; the result does not depend on it")
        ->type_name("INT")
        ->capture_default_str();
    for (const auto& [option, path, help] : log_option_table) {
        bind_option(app, option, path, help);
    }
    app.add_flag("--json", as_json_, "Print run.json instead of a summary");
}

Json SlamCommand::default_settings() const {
    return {{"method", "gmapping"}, {"log", default_log_settings()}, {"filter", filter_settings_json({})}};
}

ExitCode SlamCommand::run(const Json& settings) {
    const auto start = Clock::now();
    check_method(settings.at("method"));
    const RbpfSettings filter_settings = filter_settings_from_json(settings.at("filter"));
    LogReport problems;
    const auto log = open_log(log_file_, log_options(settings.at("log")), problems.handler());
    RunFolder folder(folder_);
    const InterruptRequest interrupt;
    double write_s = 0.0;
    const FilterRun result = [&] {
        ThreadPool threads(threads_);
        Rbpf filter(filter_settings, threads);
        Progress progress("slam", "scans");
        return run_filter(*log, filter, [&](const SensorFrame& frame, bool moved) {
            if (moved) {
                const StageTimer timer(write_s);
                folder.add(frame, filter);
            }
            progress.update(log->fraction_read(), log->summary().scans);
            return !interrupt.made();
        });
    }();
    return_freed_memory();  // the particles' maps, before pictures are drawn
    if (result.trajectory.empty()) {
        throw Error(log_file_ + ": no scans that can be used");
    }
    const MapRaster map = map_raster(result.map);
    {
        const StageTimer timer(write_s);
        folder.finish(result, map);
    }
    folder.write_json("config.json", settings);
    Json run = run_report(result, map);
    run["stages"]["write_s"] = write_s;
    const ProcessUsage usage = process_usage();
    const Json report{{"command", "slam"},
                      {"versions", version_report()},
                      {"settings", settings},
                      {"log", log_report(log_file_, log->summary())},
                      {"run", run},
                      {"interrupted", interrupt.made()},
                      {"cost",
                       {{"threads", threads_},
                        {"wall_s", std::chrono::duration<double>(Clock::now() - start).count()},
                        {"cpu_s", usage.cpu_s},
                        {"peak_memory_bytes", usage.peak_memory_bytes}}}};
    folder.write_json("run.json", report);
    std::cout << (as_json_ ? report.dump(2) + "\n" : summary_text(report, folder_, folder.files()));
    const ExitCode loss = problems.finish(log->summary());
    if (interrupt.made()) {
        log_warning("interrupted: the results end after " + std::to_string(result.trajectory.size()) + " scans");
        return ExitCode::done_with_loss;
    }
    return loss;
}

}  // namespace ddtool
