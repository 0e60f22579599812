#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <utility>

#include "check/self_check.hpp"
#include "check/verdict.hpp"
#include "commands.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "detectors.hpp"
#include "graph/back_end.hpp"
#include "graph/node_recorder.hpp"
#include "live_run_options.hpp"
#include "localization/localizer.hpp"
#include "maps/going_on.hpp"
#include "maps/map_file.hpp"
#include "merging/next_drive.hpp"
#include "methods/settings_json.hpp"
#include "number_list.hpp"
#include "output_folder.hpp"
#include "run/run_folder.hpp"
#include "run/run_page.hpp"
#include "run/run_summary.hpp"
#include "setting_lists.hpp"
#include "slam_report.hpp"
#include "system/interrupt.hpp"
#include "system/log.hpp"
#include "system/process_usage.hpp"
#include "system/progress.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

struct SlamRequest {
    LiveRunRequest run;
    std::string map;
    std::string initial_pose;
    std::string folder;
    std::size_t threads = 0;
    bool with_snapshots = false;
    bool as_json = false;
};

/// Who hears of each scan after the filter.
struct Listeners {
    RunFolder& folder;
    check::SelfCheck& check;
    graph::NodeRecorder& recorder;
    graph::BackEnd* back_end = nullptr;
    std::vector<graph::Node>* nodes = nullptr;  ///< of a run that goes on with a map; else they go to the folder
    Served* served = nullptr;
    RobotLink* robot = nullptr;
};

/// Runs the filter over the scans. The filter is destroyed at the end, so that the memory of its particles can be
/// returned before the pictures are drawn.
FilterRun run_over(DrivenScans& scans, std::unique_ptr<ParticleFilter> filter, const InterruptRequest& interrupt,
                   const Listeners& listeners) {
    const auto& [folder, check, recorder, back_end, nodes, served, robot] = listeners;
    Progress progress("slam", "scans");
    PlacedScans placed = placed_scans(scans, *filter, robot);
    const auto* const localizer = dynamic_cast<const localization::Localizer*>(filter.get());
    const auto maps_now = [&] { return localizer == nullptr || localizer->is_mapping(); };
    bool was_mapping = maps_now();
    FilterRun run = run_filter(placed, *filter, [&](const SensorFrame& frame, const std::optional<Update>& update) {
        if (robot != nullptr) {
            // first, because it waits for where it is
            robot->add(frame, update, *filter, localizer != nullptr ? &localizer->standing() : nullptr);
        }
        folder.add(frame, update, *filter);
        check.add(frame, update);
        if (std::optional<graph::Node> node = recorder.add(frame, update); node && was_mapping) {
            if (nodes != nullptr) {
                nodes->push_back(std::move(*node));
            } else {
                folder.add(*node);
                if (back_end != nullptr) {
                    back_end->add(std::move(*node));
                }
            }
        }
        if (!was_mapping && maps_now()) {
            was_mapping = true;
            recorder.restart();
        }
        if (served != nullptr) {
            served->run.add(frame, update, *filter);
        }
        progress.update(scans.fraction_read(), scans.summary().scans);
        return !interrupt.made();
    });
    return run;
}

std::optional<graph::BackEnd> back_end_of(const Json& settings, const FilterSettings& filter) {
    return asks_for_graph(settings) ? std::optional<graph::BackEnd>(filter.rbpf) : std::nullopt;
}

/// Replaces the path and the map of the run by those of the back end. Where it cannot finish, the run stays as the
/// filter made it, and `problem` says why.
std::optional<BackEndResults> smoothed(const graph::BackEnd& back_end, FilterRun& run, std::string& problem) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu_before_s = process_usage().cpu_s;
    try {
        BackEndResults results{
            .smoothed = back_end.finish(run.trajectory), .by_filter = run.trajectory, .ground_truth = run.ground_truth};
        results.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

/// One line for each reason of the self-check.
std::vector<std::string> doubts_of(const check::Verdict& verdict) {
    std::vector<std::string> lines;
    for (const std::string& reason : verdict.reasons) {
        lines.push_back("the result is " + check::name_of(verdict.standing) + ": " + reason);
    }
    return lines;
}

/// The map of a map file that the run goes on with; its limit on memory is that of the run's maps. Empty if none was
/// given.
std::optional<maps::SavedMap> map_before(const SlamRequest& request, const OccupancySettings& cells) {
    if (request.map.empty()) {
        return std::nullopt;
    }
    maps::SavedMap map = maps::read_map(request.map, maps::MapParts::all,
                                        cells.most_memory_mib > 0 ? cells.most_memory_mib : usual_most_memory_mib());
    if (map.nodes.empty()) {
        throw Error(request.map + ": a map without scans; expected a map.ddmap of a run");
    }
    return map;
}

/// The filter of the settings, or with a map of before one that finds itself in it and maps on.
std::unique_ptr<ParticleFilter> filter_of(const SlamRequest& request, const FilterSettings& settings,
                                          const DetectorTable& detectors, ThreadPool& threads,
                                          const std::optional<maps::SavedMap>& before) {
    if (!before) {
        return make_filter(settings, detectors, threads);
    }
    if (settings.rbpf.likelihood_gain <= 0.0) {
        throw UsageError("filter.likelihood_gain: expected more than 0 with --map, whose places are weighed by it");
    }
    const std::optional<localization::StartPose> start =
        request.initial_pose.empty()
            ? std::nullopt
            : std::optional(localization::StartPose{.pose = pose_option("--initial-pose", request.initial_pose)});
    return std::make_unique<localization::Localizer>(
        settings.rbpf, localization::ModeResamplingSettings{.least_particles = settings.rbpf.particles}, threads,
        make_strategies(settings, detectors), std::make_shared<const OccupancyGrid>(before->grid), start,
        localization::MapUse::going_on);  // copies of the grid fade as it does
}

/// Adds the run to the map that it went on with. Empty if no scan of it entered the map.
std::optional<merging::Added> add_to(maps::SavedMap& before, const std::string& log, const FilterRun& run,
                                     std::vector<graph::Node> nodes, const Json& settings,
                                     const maps::GoingOnSettings& going_on) {
    std::vector<maps::MapNode> placed;
    for (graph::Node& node : nodes) {
        if (node.scan < run.trajectory.size()) {
            const Pose2& pose = run.trajectory[node.scan].pose;
            placed.push_back({.drive = 0, .scan = std::move(node), .pose = pose});
        }
    }
    if (placed.empty()) {
        return std::nullopt;
    }
    before.settings = settings;
    const merging::Added added =
        merging::add_drive(before, {.log = log, .odometry = run.odometry}, std::move(placed), run.map, going_on);
    log_info("the map has " + std::to_string(before.nodes.size()) + " scans of " +
             std::to_string(before.drives.size()) + " drives now; this one is tied to those of before by " +
             std::to_string(added.seams) + " edges, and made " + std::to_string(added.dropped) +
             " scans of before needless");
    return added;
}

ExitCode slam(const SlamRequest& request, const Json& settings) {
    const auto start = std::chrono::steady_clock::now();
    const std::string source = source_of(request.run, "slam");
    FilterSettings filter_settings = filter_settings_from_json(settings.at("filter"));
    std::optional<graph::BackEnd> back_end = back_end_of(settings, filter_settings);
    if (back_end && !request.map.empty()) {
        throw UsageError("--back-end: expected none with --map: the graph of a run cannot hold the map of before");
    }
    const maps::GoingOnSettings going_on = maps::going_on_from_json(settings.at(maps::going_on_name));
    std::optional<maps::SavedMap> before = map_before(request, filter_settings.rbpf.grid);
    if (before) {
        filter_settings.rbpf.grid = before->grid.settings();
        before->grid.fade(going_on.half_life_scans);
    }
    ThreadPool threads(request.threads);
    const auto truth = std::make_shared<ScanTruth>();
    DetectorTable detectors = all_detectors();
    detectors.know(truth);
    // The detector is made before the log is opened, because a detector that needs LibTorch starts the command anew.
    std::unique_ptr<ParticleFilter> filter = filter_of(request, filter_settings, detectors, threads, before);
    const std::unique_ptr<RobotLink> robot = robot_of(request.run);
    const std::unique_ptr<Served> served = served_by(request.run);
    LogReport problems;
    const InterruptRequest interrupt;
    DrivenScans scans(scans_of(request.run, log_options(settings.at("log")), interrupt, problems, robot.get()),
                      filter_settings.rbpf);
    scans.tell_truth(truth);
    const OutputFolder output(request.folder, name_of_results(source));
    RunFolder folder(output.path(), request.with_snapshots);
    std::vector<graph::Node> nodes;
    if (!before) {
        folder.begin_map_file(program_version(), settings, filter_settings.rbpf.grid);
    }
    check::SelfCheck check;
    graph::NodeRecorder recorder(filter_settings.rbpf);
    FilterRun result = run_over(scans, std::move(filter), interrupt,
                                {folder, check, recorder, back_end ? &*back_end : nullptr, before ? &nodes : nullptr,
                                 served.get(), robot.get()});
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
    std::optional<merging::Added> added;
    if (before) {
        added = add_to(*before, source, result, std::move(nodes), settings, going_on);
        folder.write_map_file(program_version(), *before);
    } else {
        folder.finish_map_file(source, result, results_of_back_end ? &results_of_back_end->smoothed.graph : nullptr);
    }
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
                       {"interrupted", interrupt.made() && !request.run.ros},
                       {"ended_early", result.ended_early},
                       {"run", to_run_json(run)},
                       {"self_check", check::self_check_json(verdict, evidence)},
                       {"robot", robot ? robot->report() : Json()},
                       {"back_end", results_of_back_end ? back_end_json(*results_of_back_end) : Json()},
                       {"cost", cost}};
    folder.write_json("run.json", results);
    std::vector<std::string> losses = shortfalls(source, scans.summary(), interrupt.made() && !request.run.ros, result);
    if (robot) {
        const std::vector<std::string> of_robot = robot->losses();
        losses.insert(losses.end(), of_robot.begin(), of_robot.end());
    }
    const std::vector<std::string> doubts = doubts_of(verdict);
    if (before && !added) {
        losses.push_back(source + ": the robot was never sure of its place in " + request.map +
                         ": nothing was added to the map");
    }
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
                         .first_facts = {{"self-check", check::name_of(verdict.standing)}},
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
    serve_on(served.get(), interrupt);
    return losses.empty() && has_page ? log_loss : ExitCode::done_with_loss;
}

}  // namespace

Command slam_command() {
    const auto request = std::make_shared<SlamRequest>();
    std::vector<Option> options;
    append_input_options(options, request->run);
    options.insert(
        options.end(),
        {
            {"--map", &request->map,
             "Go on with this map, a map.ddmap of a run: the robot finds its place in it first, and its origin stays",
             "FILE.ddmap"},
            {.name = "--initial-pose",
             .value = &request->initial_pose,
             .help = "Where the robot is at the first scan, in metres and radians in the map; else the whole map is "
                     "searched",
             .type = "X,Y,YAW",
             .needs = "--map"},
            {"--out", &request->folder, "Folder for the results; if not given, a new one named after the log", "DIR"},
            {"--method", SettingPath{"filter.method"}, "What the filter does about degeneracy",
             choices(method_names())},
            {"--detector", SettingPath{"filter.detector"},
             "What tells the degree, or a model's file; empty: the method's own",
             choices(all_detectors().names()) + "|FILE"},
            {"--back-end", SettingPath{"back_end"},
             "graph: at the end, close loops and smooth the path with a pose graph, and draw the map anew",
             "graph|none"},
            {"--particles", SettingPath{"filter.particles"}, "Hypotheses, each with its own map"},
            {"--seed", SettingPath{"filter.seed"}, "Of all chance: the same seed gives the same result"},
            {"--max-memory", SettingPath{"filter.grid.most_memory_mib"},
             "The run ends with what it has when its maps would take more MiB; 0: three quarters of what is free"},
            {"--threads", &request->threads, "0: every core; the result does not depend on it", "INT"},
        });
    append_log_options(options);
    append_serve_options(options, request->run);
    append_ros_arguments(options, request->run);
    options.insert(options.end(), {{"--snapshots", &request->with_snapshots,
                                    "Write snapshots.mcap, too: the particles before each resampling"},
                                   {"--json", &request->as_json, "Print run.json instead of a summary"}});
    return {.name = "slam",
            .summary = "Map and trajectory from a log",
            .example = "ddtool slam --log run.mcap",
            .settings = default_slam_settings(),
            .options = std::move(options),
            .run = [request](const Json& settings) { return slam(*request, settings); }};
}

}  // namespace ddtool
