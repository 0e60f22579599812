#include <iostream>
#include <memory>

#include "commands.hpp"
#include "report/table.hpp"
#include "scores/tum_file.hpp"
#include "sim/simulation_json.hpp"
#include "sim/simulation_log.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_picture.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

struct SimulateRequest {
    std::string log;
    std::string picture;
    std::string truth;
    std::string odometry;
    bool as_json = false;
};

/// The worlds with a fixed name. The name of a world that is drawn at random contains a colon and a seed.
std::vector<std::string> plain_world_names() {
    std::vector<std::string> names;
    for (const sim::WorldEntry& entry : sim::list_worlds()) {
        if (entry.name.find(':') == std::string::npos) {
            names.push_back(entry.name);
        }
    }
    return names;
}

void print_worlds(bool as_json) {
    Table table({{"world"}, {"what"}});
    for (const sim::WorldEntry& entry : sim::list_worlds()) {
        table.add_row({entry.name, entry.description});
    }
    if (as_json) {
        std::cout << Json{{"worlds", table.json()}}.dump(2) << '\n';
        return;
    }
    std::cout << table.text()
              << "With -textured behind it, any of them has doors, skirting, pillars and rough outlines.\n"
              << "A world of your own is a JSON file: --world my-world.json\n";
}

void write_log(const sim::Simulation& simulation, const std::string& file) {
    Progress progress("simulate", "scans");
    sim::write_simulation_log(simulation, file, [&](std::size_t scans) {
        progress.update(static_cast<double>(scans) / static_cast<double>(simulation.frame_count()), scans);
    });
}

Table summary_table(const sim::World& world, const sim::Simulation& simulation) {
    const Trajectory& truth = simulation.truth();
    const Pose2 true_end = between(truth.front().pose, truth.back().pose);
    Table table({{"world"}, {"scans"}, {"duration_s", 1}, {"path_m", 1}, {"odometry_end_error_m"}});
    table.add_row({world.name, static_cast<std::int64_t>(simulation.frame_count()),
                   1e-9 * static_cast<double>(truth.back().stamp_ns - truth.front().stamp_ns), path_length_m(truth),
                   distance_m(true_end, simulation.odometry().back().pose)});
    return table;
}

/// The files that the user asked for; the keys say what they contain.
Json files_of(const SimulateRequest& request) {
    Json files = Json::object();
    const auto add = [&files](const char* content, const std::string& file) {
        if (!file.empty()) {
            files[content] = file;
        }
    };
    add("log", request.log);
    add("ground_truth", request.truth);
    add("odometry", request.odometry);
    add("picture", request.picture);
    return files;
}

ExitCode simulate(const SimulateRequest& request, const Json& settings) {
    const std::string name = settings.at("world");
    if (name == "list") {
        print_worlds(request.as_json);
        return ExitCode::done;
    }
    const sim::World world = sim::load_world(name);
    const sim::Simulation simulation(world, sim::simulation_from_json(settings));
    if (!request.picture.empty()) {
        sim::write_world_picture(request.picture, world, simulation.truth());
    }
    if (!request.truth.empty()) {
        write_tum(request.truth, simulation.truth_at_scans());
    }
    if (!request.odometry.empty()) {
        write_tum(request.odometry, simulation.odometry());
    }
    if (!request.log.empty()) {
        write_log(simulation, request.log);
    }
    const Table summary = summary_table(world, simulation);
    if (request.as_json) {
        std::cout << Json{{"command", "simulate"},
                          {"settings", settings},
                          {"drive", summary.json().at(0)},
                          {"files", files_of(request)}}
                         .dump(2)
                  << '\n';
    } else {
        std::cout << summary.text();
    }
    return ExitCode::done;
}

}  // namespace

Command simulate_command() {
    const auto request = std::make_shared<SimulateRequest>();
    return {
        .name = "simulate",
        .summary = "Drive a robot through a world where the truth is known",
        .example = "ddtool simulate --world s2 --seed 1 --out s2.mcap --png s2.png",
        .settings = sim::default_simulation_json(),
        .options =
            {
                {"--world", SettingPath{"world"}, "The world, also one drawn by a seed; 'list' describes them",
                 choices(plain_world_names()) + "|list|FILE.json"},
                {"--seed", SettingPath{"seed"}, "Of the sensors' noise; the way driven is the same for all"},
                {"--lidar", SettingPath{"lidar.preset"}, "The sensor", "ls-m10p|rplidar-a1|hokuyo-utm-30lx|sick-lms"},
                {"--odometry", SettingPath{"odometry.preset"}, "How well the wheels measure", "good|typical|poor"},
                {"--imu", SettingPath{"imu.rate_hz"}, "Readings of an inertial sensor per second; 0: there is none",
                 "HZ"},
                {"--out", &request->log, "Log to write, with the truth in it", "FILE.mcap"},
                {"--ground-truth", &request->truth, "True poses at the scans to write", "FILE.tum"},
                {"--odometry-track", &request->odometry, "Odometry to write", "FILE.tum"},
                {"--png", &request->picture, "Picture of the world and the driven way to write", "FILE.png"},
                {"--json", &request->as_json, "Print JSON instead of a table"},
            },
        .run = [request](const Json& settings) { return simulate(*request, settings); }};
}

}  // namespace ddtool
