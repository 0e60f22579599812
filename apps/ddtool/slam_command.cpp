#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "check/self_check.hpp"
#include "check/verdict.hpp"
#include "commands.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "detectors.hpp"
#include "graph/back_end.hpp"
#include "log_options.hpp"
#include "logs/stream/live_log.hpp"
#include "methods/settings_json.hpp"
#include "output_folder.hpp"
#include "robot_provider.hpp"
#include "run/live_run.hpp"
#include "run/live_server.hpp"
#include "run/placed_scans.hpp"
#include "run/run_folder.hpp"
#include "run/run_page.hpp"
#include "run/run_summary.hpp"
#include "setting_lists.hpp"
#include "slam_report.hpp"
#include "system/interrupt.hpp"
#include "system/log.hpp"
#include "system/process_usage.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;

struct SlamRequest {
    std::string log;
    bool ros = false;
    std::vector<std::string> ros_arguments;
    bool follow = false;
    std::string folder;
    std::size_t threads = 0;
    bool with_snapshots = false;
    bool as_json = false;
    bool serve = false;
    std::uint16_t port = 8765;
    std::string address = "127.0.0.1";
};

/// The server of --serve, and the messages of the run that it sends.
struct Served {
    Served(const std::string& address, std::uint16_t port) : server(address, port) {
        log_info("serving the run at ws://" + server.place() + " (Foxglove WebSocket)");
    }

    LiveServer server;
    LiveRun run{server};
};

/// Who hears of each scan after the filter.
struct Listeners {
    RunFolder& folder;
    check::SelfCheck& check;
    graph::BackEnd* back_end = nullptr;
    Served* served = nullptr;
    RobotLink* robot = nullptr;
};

/// Runs the filter over the scans. The filter is destroyed at the end, so that the memory of its particles can be
/// returned before the pictures are drawn.
FilterRun run_over(DrivenScans& scans, std::unique_ptr<ParticleFilter> filter, const InterruptRequest& interrupt,
                   const Listeners& listeners) {
    const auto& [folder, check, back_end, served, robot] = listeners;
    Progress progress("slam", "scans");
    PlacedScans placed(scans, *filter,
                       [&] { return robot != nullptr ? robot->take_initial_pose() : std::optional<Pose2>(); });
    return run_filter(placed, *filter, [&](const SensorFrame& frame, const std::optional<Update>& update) {
        if (robot != nullptr) {
            robot->add(frame, update, *filter);  // first, because it waits for where it is
        }
        folder.add(frame, update, *filter);
        check.add(frame, update);
        if (back_end != nullptr) {
            back_end->add(frame, update);
        }
        if (served != nullptr) {
            served->run.add(frame, update, *filter);
        }
        progress.update(scans.fraction_read(), scans.summary().scans);
        return !interrupt.made();
    });
}

std::optional<graph::BackEnd> back_end_of(const Json& settings, const FilterSettings& filter) {
    return asks_for_graph(settings) ? std::optional<graph::BackEnd>(filter.rbpf) : std::nullopt;
}

/// Replaces the path and the map of the run by those of the back end. Where it cannot finish, the run stays as the
/// filter made it, and `problem` says why.
std::optional<BackEndResults> smoothed(const graph::BackEnd& back_end, FilterRun& run, std::string& problem) {
    const auto start = Clock::now();
    const double cpu_before_s = process_usage().cpu_s;
    try {
        BackEndResults results{
            .smoothed = back_end.finish(run.trajectory), .by_filter = run.trajectory, .ground_truth = run.ground_truth};
        results.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
        results.cpu_s = process_usage().cpu_s - cpu_before_s;
        run.trajectory = results.smoothed.trajectory;
        if (results.smoothed.map) {
            run.map = *results.smoothed.map;
        }
        return results;
    } catch (const Error& error) {
        problem = std::string("the back end was left out, path and map are the filter's: ") + error.what();
        return std::nullopt;
    }
}

/// The reasons, other than damage, why less of the log was used than it holds or a run needs.
/// \param has_no_end the run is over when it is interrupted
std::vector<std::string> shortfalls(const std::string& file, const LogSummary& log, const InterruptRequest& interrupt,
                                    bool has_no_end, const FilterRun& run) {
    std::vector<std::string> lines;
    if (interrupt.made() && !has_no_end) {
        lines.push_back("interrupted: the results end after scan " + std::to_string(run.trajectory.size()));
    }
    if (!run.ended_early.empty()) {
        lines.push_back(file + ": " + run.ended_early + "; the results end after scan " +
                        std::to_string(run.trajectory.size()));
    }
    if (!log.has_odometry) {
        lines.push_back(
            file + ": without odometry the motion was worked out from the scans, which fails where they look alike");
    }
    return lines;
}

/// One line for each reason of the self-check.
std::vector<std::string> doubts_of(const check::Verdict& verdict) {
    std::vector<std::string> lines;
    for (const std::string& reason : verdict.reasons) {
        lines.push_back("the result is " + check::name_of(verdict.standing) + ": " + reason);
    }
    return lines;
}

RunCost run_cost(std::size_t threads, Clock::time_point start) {
    const ProcessUsage usage = process_usage();
    return {.threads = threads,
            .wall_s = std::chrono::duration<double>(Clock::now() - start).count(),
            .cpu_s = usage.cpu_s,
            .peak_memory_bytes = usage.peak_memory_bytes};
}

std::unique_ptr<LogStream> open(const SlamRequest& request, const LogOptions& options,
                                const InterruptRequest& interrupt, LogReport& problems, RobotLink* robot) {
    const auto stop = [&interrupt] { return interrupt.made(); };
    if (robot != nullptr) {
        return robot->scans(options, stop, problems.handler());
    }
    if (request.log != "-") {
        return request.follow ? follow_log(request.log, options, stop, problems.handler())
                              : open_log(request.log, options, problems.handler());
    }
    if (request.follow) {
        throw UsageError("--follow: expected the file that is being written; standard input ends by itself");
    }
    return open_standard_input(options, stop, problems.handler());
}

/// What the scans come from, as messages and the folder of the results name it.
std::string source_of(const SlamRequest& request) {
    if (request.ros != request.log.empty()) {
        throw UsageError("slam: expected --log FILE, or --ros for a robot that is driving now" +
                         std::string(request.ros ? ", and not both" : ""));
    }
    if (request.ros && request.follow) {
        throw UsageError("--follow: expected --log with the file that is being written; a robot is followed anyway");
    }
    return request.ros ? "ros" : request.log;
}

ExitCode slam(const SlamRequest& request, const Json& settings) {
    const auto start = Clock::now();
    const std::string source = source_of(request);
    const FilterSettings filter_settings = filter_settings_from_json(settings.at("filter"));
    std::optional<graph::BackEnd> back_end = back_end_of(settings, filter_settings);
    ThreadPool threads(request.threads);
    const auto truth = std::make_shared<ScanTruth>();
    DetectorTable detectors = all_detectors();
    detectors.know(truth);
    // The detector is made before the log is opened, because a detector that needs LibTorch starts the command anew.
    std::unique_ptr<ParticleFilter> filter = make_filter(filter_settings, detectors, threads);
    const std::unique_ptr<RobotLink> robot = request.ros ? join_robot(request.ros_arguments) : nullptr;
    const auto served = request.serve ? std::make_unique<Served>(request.address, request.port) : nullptr;
    LogReport problems;
    const InterruptRequest interrupt;
    DrivenScans scans(open(request, log_options(settings.at("log")), interrupt, problems, robot.get()),
                      filter_settings.rbpf);
    scans.tell_truth(truth);
    const OutputFolder output(request.folder, name_of_results(source));
    RunFolder folder(output.path(), request.with_snapshots);
    check::SelfCheck check;
    FilterRun result = run_over(scans, std::move(filter), interrupt,
                                {folder, check, back_end ? &*back_end : nullptr, served.get(), robot.get()});
    return_freed_memory();  // returns the memory of the particles' maps before the pictures are drawn
    if (result.trajectory.empty()) {
        throw Error(source + ": no scans that can be used");
    }
    std::string back_end_problem;
    const std::optional<BackEndResults> results_of_back_end =
        back_end ? smoothed(*back_end, result, back_end_problem) : std::nullopt;
    const MapRaster map = map_raster(result.map);
    if (served) {
        served->run.finish(map, result.trajectory);
    }
    if (robot) {
        robot->finish(map, result.trajectory);
    }
    folder.finish(result, map);
    folder.write_back_end(results_of_back_end ? &*results_of_back_end : nullptr);
    folder.write_json("config.json", settings);
    const RunSummary run = run_summary(result, map, folder.course(), folder.write_s());
    const RunCost cost = run_cost(request.threads, start);
    const check::Evidence evidence = check.evidence(result.trajectory);
    const check::Verdict verdict = check::verdict_of(evidence);
    const Json log = log_report(source, scans.summary());
    const Json versions = version_report();
    const Json results{{"command", "slam"},
                       {"versions", versions},
                       {"settings", settings},
                       {"parts", parts_json(filter_settings.method)},
                       {"log", log},
                       {"interrupted", interrupt.made() && !request.ros},
                       {"ended_early", result.ended_early},
                       {"run", to_run_json(run)},
                       {"self_check", check::self_check_json(verdict, evidence)},
                       {"robot", robot ? robot->report() : Json()},
                       {"back_end", results_of_back_end ? back_end_json(*results_of_back_end) : Json()},
                       {"cost", cost}};
    folder.write_json("run.json", results);
    std::vector<std::string> losses = shortfalls(source, scans.summary(), interrupt, request.ros, result);
    if (robot) {
        const std::vector<std::string> of_robot = robot->losses();
        losses.insert(losses.end(), of_robot.begin(), of_robot.end());
    }
    const std::vector<std::string> doubts = doubts_of(verdict);
    if (!back_end_problem.empty()) {
        losses.push_back(source + ": " + back_end_problem);
    }
    losses.insert(losses.end(), doubts.begin(), doubts.end());
    std::vector<std::string> warnings = log_warnings(scans.summary());
    warnings.insert(warnings.end(), losses.begin(), losses.end());
    const bool has_page = folder.write_page([&] {
        return run_page({.log_file = source,
                         .warnings = warnings,
                         .run = result,
                         .map = map,
                         .course = folder.course(),
                         .summary = run,
                         .cost = cost,
                         .self_check = check::name_of(verdict.standing),
                         .image = image_seen_by(parts_of(filter_settings.method).detector),
                         .back_end = results_of_back_end ? &*results_of_back_end : nullptr,
                         .settings = settings,
                         .log = log,
                         .versions = versions});
    });
    std::cout << (request.as_json ? results.dump(2) + "\n"
                                  : slam_summary(run, cost, check::name_of(verdict.standing), output.path().string(),
                                                 folder.files()));
    const ExitCode log_loss = problems.finish(scans.summary());
    std::for_each(losses.begin(), losses.end(), log_warning);
    log_info("next: open " + (output.path() / "report.html").string() +
             " in a browser; to train a detector of degeneracy: ddtool build-dataset");
    if (served && !interrupt.made()) {
        log_info("the run is over; its map is served until Ctrl-C");
        std::cout.flush();
        interrupt.wait();
    }
    return losses.empty() && has_page ? log_loss : ExitCode::done_with_loss;
}

}  // namespace

Command slam_command() {
    const auto request = std::make_shared<SlamRequest>();
    std::vector<Option> options{
        {"--log", &request->log, log_file_help + std::string("; - is MCAP from standard input"), "FILE"},
        {"--follow", &request->follow, "The log is MCAP that is still being written: wait for more, up to its footer"},
        {.name = "--ros",
         .value = &request->ros,
         .help = "Map a robot of ROS 2 that is driving now, until Ctrl-C: its scans, odometry and transforms are read, "
                 "map -> odom and the map are published",
         .excludes = "--log"},
        {"--out", &request->folder, "Folder for the results; if not given, a new one named after the log", "DIR"},
        {"--method", SettingPath{"filter.method"}, "What the filter does about degeneracy", choices(method_names())},
        {"--detector", SettingPath{"filter.detector"},
         "What tells the degree, or a model's file; empty: the method's own",
         choices(all_detectors().names()) + "|FILE"},
        {"--back-end", SettingPath{"back_end"},
         "graph: at the end, close loops and smooth the path with a pose graph, and draw the map anew", "graph|none"},
        {"--particles", SettingPath{"filter.particles"}, "Hypotheses, each with its own map"},
        {"--seed", SettingPath{"filter.seed"}, "Of all chance: the same seed gives the same result"},
        {"--max-memory", SettingPath{"filter.grid.most_memory_mib"},
         "The run ends with what it has when its maps would take more MiB; 0: three quarters of what is free"},
        {"--threads", &request->threads, "0: every core; the result does not depend on it", "INT"},
    };
    append_log_options(options);
    options.insert(
        options.end(),
        {{.name = "--serve",
          .value = &request->port,
          .help = "Show the run as it goes on to Foxglove or Lichtblick, at this port (0: any that is free); "
                  "after the end of the log the map stays to be seen until Ctrl-C",
          .type = "PORT",
          .alone = "8765",
          .given = &request->serve},
         {.name = "--serve-address",
          .value = &request->address,
          .help = "This machine's address that others may connect to; 127.0.0.1 is for itself alone, 0.0.0.0 all",
          .type = "ADDRESS",
          .needs = "--serve"},
         {.name = "--ros-args",
          .value = &request->ros_arguments,
          .help = "What a node of ROS 2 takes, up to the end of the line or --: -r FROM:=TO (topics, __ns, __node), "
                  "-p use_sim_time:=true, -p transform_tolerance:=SECONDS",
          .type = "WORDS",
          .needs = "--ros",
          .takes_rest = true},
         {"--snapshots", &request->with_snapshots, "Write snapshots.mcap, too: the particles before each resampling"},
         {"--json", &request->as_json, "Print run.json instead of a summary"}});
    return {.name = "slam",
            .summary = "Map and trajectory from a log",
            .example = "ddtool slam --log run.mcap",
            .settings = default_slam_settings(),
            .options = std::move(options),
            .run = [request](const Json& settings) { return slam(*request, settings); }};
}

}  // namespace ddtool
