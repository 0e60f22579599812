#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "bench_worlds.hpp"
#include "methods/settings_json.hpp"
#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"

namespace ddtool::matcher_bench {
namespace {

struct Options {
    Plan plan;
    std::vector<int> beams{usual_lidar.beams};
    std::vector<double> ranges_m{usual_lidar.range_max_m};
    std::vector<double> noises_m{usual_lidar.range_noise_m};
    std::vector<std::string> settings;
    bool sweep = false;
    bool quick = false;
    std::filesystem::path json;
    std::filesystem::path picture;
};

std::string world_list() {
    std::string text;
    for (const WorldKind& kind : world_kinds()) {
        text += "  " + kind.name + std::string(10 - kind.name.size(), ' ') + kind.description + "\n";
    }
    return text;
}

void declare(CLI::App& app, Options& options) {
    Plan& plan = options.plan;
    for (const WorldKind& kind : world_kinds()) {
        plan.worlds.push_back(kind.name);
    }
    app.add_option("--worlds", plan.worlds, "Worlds, separated by commas; all by default")->delimiter(',');
    app.add_option("--cells", plan.cell_sizes_m, "Cell sizes of the map, in m")
        ->delimiter(',')
        ->check(CLI::Range(0.005, 0.5))
        ->capture_default_str();
    app.add_option("--beams", options.beams, "Beams of the lidar in a full turn")
        ->delimiter(',')
        ->check(CLI::Range(8, 10'000))
        ->capture_default_str();
    app.add_option("--range", options.ranges_m, "Maximum ranges of the lidar, in m")
        ->delimiter(',')
        ->check(CLI::Range(1.0, 30.0))
        ->capture_default_str();
    app.add_option("--noise", options.noises_m, "Standard deviations of the ranges, in m")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 0.2))
        ->capture_default_str();
    app.add_flag("--sweep", options.sweep,
                 "Also lidars that differ in one number: 180, 720, 1680 beams; 4, 8, 30 m; 5, 30 mm");
    app.add_option("--layouts", plan.layouts, "Drawn layouts of each world")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    app.add_option("--length", plan.length_m, "Length of each corridor, in m")
        ->check(CLI::Range(10.0, 10'000.0))
        ->capture_default_str();
    app.add_flag("--known-map", plan.known_map,
                 "Match in a map that was driven through before, instead of at the frontier");
    app.add_option("--seed", plan.trials.seed, "Of the noise of the scans")->capture_default_str();
    app.add_option("--set", options.settings,
                   "Another setting of the filter's map or matcher, such as filter.matcher.reach_m=0.1")
        ->take_all();
    app.add_flag("--quick", options.quick, "One layout of 30 m and cells of 5 cm: seconds, for a first look");
    app.add_option("--json", options.json, "Also write all figures to this file");
    app.add_option("--png", options.picture, "Also draw bias, drift and spread to this file");
}

void apply_settings(Options& options) {
    Json json{{"filter", filter_settings_json({})}};
    for (const std::string& assignment : options.settings) {
        if (assignment.starts_with("filter.grid.cell_size_m=")) {
            throw UsageError("--set " + assignment + ": expected --cells for the cell size");
        }
        merge_assignment(json, assignment);
    }
    options.plan.trials.filter = filter_settings_from_json(json["filter"]).rbpf;
}

void add_lidars(Options& options) {
    std::vector<sim::LidarSettings>& lidars = options.plan.lidars;
    lidars.clear();
    for (const int beams : options.beams) {
        for (const double range_m : options.ranges_m) {
            for (const double noise_m : options.noises_m) {
                lidars.push_back({.beams = beams, .range_max_m = range_m, .range_noise_m = noise_m});
            }
        }
    }
    if (options.sweep) {
        const sim::LidarSettings usual = lidars.front();
        const auto add = [&](auto sim::LidarSettings::*number, const auto& values) {
            for (const auto value : values) {
                lidars.push_back(usual);
                lidars.back().*number = value;
            }
        };
        add(&sim::LidarSettings::beams, std::vector<int>{180, 720, 1680});
        add(&sim::LidarSettings::range_max_m, std::vector<double>{4.0, 8.0, 30.0});
        add(&sim::LidarSettings::range_noise_m, std::vector<double>{0.005, 0.03});
    }
}

/// What --quick changes, except for what is given.
void make_quick(const CLI::App& app, Plan& plan) {
    if (app.count("--layouts") == 0) {
        plan.layouts = 1;
    }
    if (app.count("--length") == 0) {
        plan.length_m = 30.0;
    }
    if (app.count("--cells") == 0) {
        plan.cell_sizes_m = {0.05};
    }
}

int run(int argc, char** argv) {
    CLI::App app{
        "Measures the scan matcher of the filter without SLAM: its bias, spread, belief and drift in worlds of its "
        "own.\n"
        "docs/matcher-bench.md explains the figures.",
        "bench-matcher"};
    Options options;
    declare(app, options);
    app.footer(
        "Worlds:\n" + world_list() +
        "\nExample:\n  scripts/bench-matcher --worlds recesses,pillars --cells 0.05 --json bench.json --png bench.png");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (options.quick) {
        make_quick(app, options.plan);
    }
    apply_settings(options);
    add_lidars(options);
    for (const std::string& world : options.plan.worlds) {
        draw_world(world, 1, options.plan.length_m);  // throws for an unknown name before anything is measured
    }
    std::size_t done = 0;
    const std::size_t cases =
        options.plan.worlds.size() * options.plan.lidars.size() * options.plan.cell_sizes_m.size();
    const std::vector<CaseResult> results = run_plan(options.plan, [&](const CaseResult& result) {
        std::cerr << ++done << " of " << cases << ": " << result.world << "\n";
    });
    std::cout << tables(results);
    if (!options.json.empty()) {
        write_file(options.json, results_json(options.plan, results).dump(2) + "\n");
    }
    if (!options.picture.empty()) {
        write_picture(options.picture, results);
    }
    return 0;
}

}  // namespace
}  // namespace ddtool::matcher_bench

int main(int argc, char** argv) {
    try {
        return ddtool::matcher_bench::run(argc, argv);
    } catch (const ddtool::Error& error) {
        std::cerr << "bench-matcher: " << error.what() << "\n";
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::cerr << "bench-matcher: " << ddtool::failure_text(error) << "\n";
        return 1;
    }
}
