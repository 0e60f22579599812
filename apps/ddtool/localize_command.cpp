#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "detectors.hpp"
#include "live_run_options.hpp"
#include "localization/localization_settings.hpp"
#include "localization/localizer.hpp"
#include "maps/any_map.hpp"
#include "methods/settings_json.hpp"
#include "number_list.hpp"
#include "output_folder.hpp"
#include "run/localization_course.hpp"
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

struct LocalizeRequest {
    LiveRunRequest run;
    std::string map;
    std::string initial_pose;
    std::string folder;
    std::size_t threads = 1;
    bool with_snapshots = false;
    bool as_json = false;
};

std::optional<localization::StartPose> start_of(const LocalizeRequest& request) {
    return request.initial_pose.empty()
               ? std::nullopt
               : std::optional(localization::StartPose{.pose = pose_option("--initial-pose", request.initial_pose)});
}

ExitCode localize(const LocalizeRequest& request, const Json& settings) {
    const auto start = std::chrono::steady_clock::now();
    const std::string source = source_of(request.run, "localize");
    localization::LocalizationSettings wanted = localization::localization_from_json(settings);
    ThreadPool threads(request.threads);
    const auto truth = std::make_shared<ScanTruth>();
    DetectorTable detectors = all_detectors();
    detectors.know(truth);
    const std::optional<localization::StartPose> start_pose = start_of(request);
    // The detector is made before the log is opened, because a detector that needs LibTorch starts the command anew.
    const FilterStrategies strategies = make_strategies(wanted.filter, detectors);
    const auto map = std::make_shared<const OccupancyGrid>(maps::read_any_map(request.map, maps::MapParts::grid).grid);
    wanted.filter.rbpf.grid = map->settings();
    localization::Localizer localizer(wanted.filter.rbpf, wanted.particles, threads, strategies, map, start_pose);
    const std::unique_ptr<RobotLink> robot = robot_of(request.run);
    if (robot) {
        robot->show_fixed_map(map_raster(*map));
    }
    const std::unique_ptr<Served> served = served_by(request.run);
    LogReport problems;
    const InterruptRequest interrupt;
    DrivenScans scans(scans_of(request.run, log_options(settings.at("log")), interrupt, problems, robot.get()),
                      wanted.filter.rbpf);
    scans.tell_truth(truth);
    const OutputFolder output(request.folder, name_of_results(source) + "-localized");
    RunFolder folder(output.path(), request.with_snapshots);
    LocalizationCourse course(output.path() / "localization.csv");
    Progress progress("localize", "scans");
    PlacedScans placed = placed_scans(scans, localizer, robot.get());
    const FilterRun result =
        run_filter(placed, localizer, [&](const SensorFrame& frame, const std::optional<Update>& update) {
            if (robot) {
                robot->add(frame, update, localizer, &localizer.standing());  // first, because it waits for where it is
            }
            folder.add(frame, update, localizer);
            if (update) {
                course.add(*update, localizer.standing());
            }
            if (served) {
                served->run.add(frame, update, localizer);
            }
            progress.update(scans.fraction_read(), scans.summary().scans);
            return !interrupt.made();
        });
    if (result.trajectory.empty()) {
        throw Error(source + ": no scans that can be used");
    }
    const MapRaster raster = map_raster(result.map);
    if (served) {
        served->run.finish(raster, result.trajectory);
    }
    if (robot) {
        robot->finish(raster, result.trajectory);
    }
    folder.finish(result, raster);
    folder.write_back_end(nullptr);
    course.close();
    folder.write_json("config.json", settings);
    const RunSummary run = run_summary(result, raster, folder.course(), folder.write_s());
    const RunCost cost = run_cost(request.threads, start);
    const Json log = log_report(source, scans.summary());
    const Json versions = version_report();
    Json about = course.json();
    about["map"] = request.map;
    about["initial_pose"] = nullptr;
    if (start_pose) {
        about["initial_pose"] = {start_pose->pose.x_m, start_pose->pose.y_m, start_pose->pose.theta_rad};
    }
    const Json results{{"command", "localize"},
                       {"versions", versions},
                       {"settings", settings},
                       {"parts", parts_json(wanted.filter.method)},
                       {"log", log},
                       {"interrupted", interrupt.made() && !request.run.ros},
                       {"ended_early", result.ended_early},
                       {"run", to_run_json(run)},
                       {"localization", about},
                       {"robot", robot ? robot->report() : Json()},
                       {"cost", cost}};
    folder.write_json("run.json", results);
    std::vector<std::string> losses = shortfalls(source, scans.summary(), interrupt.made() && !request.run.ros, result);
    if (robot) {
        const std::vector<std::string> of_robot = robot->losses();
        losses.insert(losses.end(), of_robot.begin(), of_robot.end());
    }
    const std::vector<std::string> doubts = course.doubts();
    losses.insert(losses.end(), doubts.begin(), doubts.end());
    std::vector<std::string> warnings = log_warnings(scans.summary());
    warnings.insert(warnings.end(), losses.begin(), losses.end());
    const bool has_page = folder.write_page([&] {
        return run_page({.command = "ddtool localize",
                         .log_file = source,
                         .warnings = warnings,
                         .run = result,
                         .map = raster,
                         .course = folder.course(),
                         .summary = run,
                         .cost = cost,
                         .first_facts = course.facts(),
                         .image = image_seen_by(parts_of(wanted.filter.method).detector),
                         .settings = settings,
                         .log = log,
                         .versions = versions});
    });
    std::vector<std::string> files = folder.files();
    files.emplace_back("localization.csv");
    std::cout << (request.as_json ? results.dump(2) + "\n"
                                  : localize_summary(run, cost, course, output.path().string(), files));
    const ExitCode log_loss = problems.finish(scans.summary());
    std::for_each(losses.begin(), losses.end(), log_warning);
    log_info("next: open " + (output.path() / "report.html").string() + " in a browser");
    serve_on(served.get(), interrupt);
    return losses.empty() && has_page ? log_loss : ExitCode::done_with_loss;
}

}  // namespace

Command localize_command() {
    const auto request = std::make_shared<LocalizeRequest>();
    std::vector<Option> options{{"--map", &request->map, saved_map_help, "FILE", Presence::required}};
    append_input_options(options, request->run);
    options.insert(
        options.end(),
        {
            {"--initial-pose", &request->initial_pose,
             "Where the robot is at the first scan, in metres and radians in the map, to half a metre and 15 degrees; "
             "if not given, the whole map is searched",
             "X,Y,YAW"},
            {"--out", &request->folder, "Folder for the results; if not given, a new one named after the log", "DIR"},
            {"--method", SettingPath{"filter.method"}, "What the filter does about degeneracy",
             "rbpf|anti-degeneracy|fisher-gate|dn-csm|odometry"},
            {"--detector", SettingPath{"filter.detector"},
             "What tells the degree, or a model's file; empty: the method's own",
             choices(all_detectors().names()) + "|FILE"},
            {"--particles", SettingPath{"filter.particles"}, "The least number of particles"},
            {"--most-particles", SettingPath{"localization.most_particles"}, "The largest number of particles"},
            {"--seed", SettingPath{"filter.seed"}, "Of all chance: the same seed gives the same result"},
            {"--threads", &request->threads, "0: every core; the result does not depend on it", "INT"},
        });
    append_log_options(options);
    append_serve_options(options, request->run);
    append_ros_arguments(options, request->run);
    options.insert(options.end(), {
                                      {"--snapshots", &request->with_snapshots,
                                       "Write snapshots.mcap, too: the particles before each resampling"},
                                      {"--json", &request->as_json, "Print run.json instead of a summary"},
                                  });
    return {.name = "localize",
            .summary = "Path of a robot in a saved map, and how sure it is",
            .example = "ddtool localize --map run/map.ddmap --log tomorrow.mcap",
            .settings = default_localize_settings(),
            .options = std::move(options),
            .run = [request](const Json& settings) { return localize(*request, settings); }};
}

}  // namespace ddtool
