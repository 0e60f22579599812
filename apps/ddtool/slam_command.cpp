#include "slam_command.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "ddtool/methods/driven_scans.hpp"
#include "detectors.hpp"
#include "logs/stream/live_log.hpp"
#include "methods/settings_json.hpp"
#include "run/live_run.hpp"
#include "run/live_server.hpp"
#include "run/run_folder.hpp"
#include "run/run_page.hpp"
#include "run/run_report.hpp"
#include "slam_report.hpp"
#include "system/log.hpp"
#include "system/process_usage.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;

/// What --serve offers.
struct Served {
    Served(const std::string& address, std::uint16_t port) : server(address, port) {
        log_info("serving the run at ws://" + server.place() + " (Foxglove WebSocket)");
    }

    LiveServer server;
    LiveRun run{server};
};

/// The filter's particles end here, so that their memory can be given back before the pictures are drawn.
FilterRun run_over(DrivenScans& scans, std::unique_ptr<Rbpf> filter, const InterruptRequest& interrupt,
                   RunFolder& folder, Served* served) {
    Progress progress("slam", "scans");
    return run_filter(scans, *filter, [&](const SensorFrame& frame, const std::optional<Update>& update) {
        folder.add(frame, update, *filter);
        if (served != nullptr) {
            served->run.add(frame, update, *filter);
        }
        progress.update(scans.fraction_read(), scans.summary().scans);
        return !interrupt.made();
    });
}

/// Why less was used or there than a run needs, other than for damage.
std::vector<std::string> shortfalls(const std::string& file, const LogSummary& log, const InterruptRequest& interrupt,
                                    const FilterRun& run) {
    std::vector<std::string> lines;
    if (interrupt.made()) {
        lines.push_back("interrupted: the results end after scan " + std::to_string(run.trajectory.size()));
    }
    if (!run.ended_early.empty()) {
        lines.push_back(file + ": " + run.ended_early + "; the results end after scan " +
                        std::to_string(run.trajectory.size()));
    }
    if (!log.has_odometry) {
        lines.push_back(file +
                        ": no odometry: the motion was worked out from the scans, which fails where they look alike");
    }
    return lines;
}

CostReport cost_report(std::size_t threads, Clock::time_point start) {
    const ProcessUsage usage = process_usage();
    return {.threads = threads,
            .wall_s = std::chrono::duration<double>(Clock::now() - start).count(),
            .cpu_s = usage.cpu_s,
            .peak_memory_bytes = usage.peak_memory_bytes};
}

}  // namespace

SlamCommand::SlamCommand() : Command("slam", "Map and trajectory from a log", "ddtool slam --log run.mcap --out run") {}

void SlamCommand::add_options(CLI::App& app) {
    app.add_option("--log", log_file_, log_file_help + std::string("; - is MCAP from standard input"))
        ->type_name("FILE")
        ->required();
    app.add_flag("--follow", follow_, "The log is MCAP that is still being written: wait for more, up to its footer");
    app.add_option("--out", folder_, "Folder for the results; created where it is not there")
        ->type_name("DIR")
        ->required();
    bind_option(app, "--method", "filter.method", "What the filter does about degeneracy")
        ->type_name(choices(method_names()));
    bind_option(app, "--detector", "filter.detector",
                "What tells the degree, or a model's file; empty: the method's own")
        ->type_name(choices(all_detectors().names()) + "|FILE");
    bind_option(app, "--particles", "filter.particles", "Hypotheses, each with its own map");
    bind_option(app, "--seed", "filter.seed", "Of all chance: the same seed gives the same result");
    bind_option(app, "--max-memory", "filter.grid.most_memory_mib",
                "The run ends with what it has when its maps would take more MiB; 0: three quarters of what is free");
    app.add_option("--threads", threads_, "0: every core; the result does not depend on it")
        ->type_name("INT")
        ->capture_default_str();
    for (const auto& [option, path, help] : log_option_table) {
        bind_option(app, option, path, help);
    }
    serve_ = app.add_option("--serve", port_,
                            "Show the run as it goes on to Foxglove or Lichtblick, at this port (0: any that is free); "
                            "after the end of the log the map stays to be seen until Ctrl-C")
                 ->expected(0, 1)
                 ->type_name("PORT")
                 ->capture_default_str();
    app.add_option("--serve-address", address_,
                   "This machine's address that others may connect to; 127.0.0.1 is for itself alone, 0.0.0.0 all")
        ->type_name("ADDRESS")
        ->needs(serve_)
        ->capture_default_str();
    app.add_flag("--snapshots", with_snapshots_, "Write snapshots.mcap, too: the particles before each resampling");
    app.add_flag("--json", as_json_, "Print run.json instead of a summary");
}

Json SlamCommand::default_settings() const {
    return {{"log", default_log_settings()}, {"filter", filter_settings_json({})}};
}

std::unique_ptr<LogStream> SlamCommand::open(const LogOptions& options, const InterruptRequest& interrupt,
                                             LogReport& problems) const {
    const auto stop = [&interrupt] { return interrupt.made(); };
    if (log_file_ != "-") {
        return follow_ ? follow_log(log_file_, options, stop, problems.handler())
                       : open_log(log_file_, options, problems.handler());
    }
    if (follow_) {
        throw UsageError("--follow: expected the file that is being written; standard input ends by itself");
    }
    return open_standard_input(options, stop, problems.handler());
}

ExitCode SlamCommand::run(const Json& settings) {
    const auto start = Clock::now();
    const FilterSettings filter_settings = filter_settings_from_json(settings.at("filter"));
    ThreadPool threads(threads_);
    // Before the log is opened: a detector that needs LibTorch starts the command anew.
    std::unique_ptr<Rbpf> filter = make_filter(filter_settings, all_detectors(), threads);
    const auto served = serve_->count() > 0 ? std::make_unique<Served>(address_, port_) : nullptr;
    LogReport problems;
    const InterruptRequest interrupt;
    DrivenScans scans(open(log_options(settings.at("log")), interrupt, problems), filter_settings.rbpf);
    RunFolder folder(folder_, with_snapshots_);
    const FilterRun result = run_over(scans, std::move(filter), interrupt, folder, served.get());
    return_freed_memory();  // the particles' maps, before pictures are drawn
    if (result.trajectory.empty()) {
        throw Error(log_file_ + ": no scans that can be used");
    }
    const MapRaster map = map_raster(result.map);
    if (served) {
        served->run.finish(map, result.trajectory);
    }
    folder.finish(result, map);
    folder.write_json("config.json", settings);
    const RunReport run = run_report(result, map, folder.course(), folder.write_s());
    const CostReport cost = cost_report(threads_, start);
    const Json log = log_report(log_file_, scans.summary());
    const Json versions = version_report();
    const Json report{{"command", "slam"},
                      {"versions", versions},
                      {"settings", settings},
                      {"log", log},
                      {"interrupted", interrupt.made()},
                      {"ended_early", result.ended_early},
                      {"run", to_run_json(run)},
                      {"cost", cost}};
    folder.write_json("run.json", report);
    const std::vector<std::string> losses = shortfalls(log_file_, scans.summary(), interrupt, result);
    std::vector<std::string> warnings = log_warnings(scans.summary());
    warnings.insert(warnings.end(), losses.begin(), losses.end());
    const bool has_page = folder.write_page([&] {
        return run_page({.log_file = log_file_,
                         .warnings = warnings,
                         .run = result,
                         .map = map,
                         .course = folder.course(),
                         .report = run,
                         .cost = cost,
                         .image = image_seen_by(parts_of(filter_settings.method).detector),
                         .settings = settings,
                         .log = log,
                         .versions = versions});
    });
    std::cout << (as_json_ ? report.dump(2) + "\n" : slam_summary(run, cost, folder_, folder.files()));
    const ExitCode log_loss = problems.finish(scans.summary());
    std::for_each(losses.begin(), losses.end(), log_warning);
    if (served && !interrupt.made()) {
        log_info("the run is over; its map is served until Ctrl-C");
        std::cout.flush();
        interrupt.wait();
    }
    return losses.empty() && has_page ? log_loss : ExitCode::done_with_loss;
}

}  // namespace ddtool
