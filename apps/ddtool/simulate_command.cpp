#include "simulate_command.hpp"

#include <iostream>

#include "report/table.hpp"
#include "scores/tum_file.hpp"
#include "sim/simulation_json.hpp"
#include "sim/simulation_log.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_picture.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

/// Those that go by one word; a drawn world has a seed in its name.
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

Trajectory truth_at_scans(const sim::Simulation& simulation) {
    Trajectory truth;
    for (std::size_t index = 0; index < simulation.frame_count(); ++index) {
        const std::int64_t stamp_ns = simulation.stamp_ns(index);
        truth.push_back({stamp_ns, *pose_at(simulation.truth(), stamp_ns)});
    }
    return truth;
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

}  // namespace

SimulateCommand::SimulateCommand()
    : Command("simulate", "Drive a robot through a world where the truth is known",
              "ddtool simulate --world s2 --seed 1 --out s2.mcap --png s2.png") {}

void SimulateCommand::add_options(CLI::App& app) {
    bind_option(app, "--world", "world", "The world, also one drawn by a seed; 'list' describes them")
        ->type_name(choices(plain_world_names()) + "|list|FILE.json");
    bind_option(app, "--seed", "seed", "Of the sensors' noise; the way driven is the same for all");
    bind_option(app, "--lidar", "lidar.preset", "The sensor")->type_name("ls-m10p|rplidar-a1|hokuyo-utm-30lx|sick-lms");
    bind_option(app, "--odometry", "odometry.preset", "How well the wheels measure")->type_name("good|typical|poor");
    app.add_option("--out", log_file_, "Log to write, with the truth in it")->type_name("FILE.mcap");
    app.add_option("--ground-truth", truth_file_, "True poses at the scans to write")->type_name("FILE.tum");
    app.add_option("--odometry-track", odometry_file_, "Odometry to write")->type_name("FILE.tum");
    app.add_option("--png", picture_file_, "Picture of the world and the driven way to write")->type_name("FILE.png");
    app.add_flag("--json", as_json_, "Print JSON instead of a table");
}

Json SimulateCommand::default_settings() const { return sim::default_simulation_json(); }

Json SimulateCommand::files() const {
    Json files = Json::object();
    const auto add = [&files](const char* content, const std::string& file) {
        if (!file.empty()) {
            files[content] = file;
        }
    };
    add("log", log_file_);
    add("ground_truth", truth_file_);
    add("odometry", odometry_file_);
    add("picture", picture_file_);
    return files;
}

ExitCode SimulateCommand::run(const Json& settings) {
    const std::string name = settings.at("world");
    if (name == "list") {
        print_worlds(as_json_);
        return ExitCode::done;
    }
    const sim::World world = sim::load_world(name);
    const sim::Simulation simulation(world, sim::simulation_from_json(settings));
    if (!picture_file_.empty()) {
        sim::write_world_picture(picture_file_, world, simulation.truth());
    }
    if (!truth_file_.empty()) {
        write_tum(truth_file_, truth_at_scans(simulation));
    }
    if (!odometry_file_.empty()) {
        write_tum(odometry_file_, simulation.odometry());
    }
    if (!log_file_.empty()) {
        write_log(simulation, log_file_);
    }
    const Table summary = summary_table(world, simulation);
    if (as_json_) {
        std::cout << Json{{"command", "simulate"},
                          {"settings", settings},
                          {"drive", summary.json().at(0)},
                          {"files", files()}}
                         .dump(2)
                  << '\n';
    } else {
        std::cout << summary.text();
    }
    return ExitCode::done;
}

}  // namespace ddtool
