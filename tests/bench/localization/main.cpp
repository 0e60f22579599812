#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "ddtool/base/random.hpp"
#include "system/folder.hpp"
#include "trials.hpp"

namespace ddtool::localization_bench {
namespace {

struct Plan {
    std::vector<std::string> followed{"random:office:1", "s2", "s3", "r1@8", "r2@8", "r3@8", "r4@8", "ring@8"};
    std::vector<std::string> started{"random:office:1", "random:office:2", "ring@8"};
    std::size_t drives = 10;
    std::size_t starts = 200;
    std::size_t kidnappings = 50;
    double way_m = 10.0;
    std::vector<std::string> settings;
    std::string folder;  ///< for maps and drives as text; empty: none
    bool true_maps = false;
    bool with_mapping = false;
    bool quick = false;
};

std::string cell(const std::string& text, std::size_t width = 10) {
    return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

MadeMap made_map(const Plan& plan, const Place& place) {
    const std::vector<SensorFrame> frames = frames_of(drive_of(place, 1));
    return plan.true_maps ? true_map_of(frames) : map_of(frames);
}

/// A row of the table: medians over the drives, and the worst moment of all.
void print_errors(const std::vector<Followed>& drives, Errors Followed::*which) {
    const auto each = [&](double Errors::*figure) {
        std::vector<double> values;
        for (const Followed& drive : drives) {
            values.push_back(drive.*which.*figure);
        }
        return values;
    };
    const auto within = [&](double Errors::*share) {
        constexpr double expected_share = 0.95;
        return std::to_string(std::ranges::count_if(each(share), [](double value) { return value >= expected_share; }));
    };
    std::cout << cell(fixed_text(median(each(&Errors::ate_m)), 4), 9)
              << cell(fixed_text(std::ranges::max(each(&Errors::ate_m)), 4), 9)
              << cell(fixed_text(std::ranges::max(each(&Errors::worst_m)), 3), 9)
              << cell(fixed_text(median(each(&Errors::nees_position)), 2), 9)
              << cell(fixed_text(median(each(&Errors::nees_heading)), 2), 9)
              << cell(within(&Errors::within_position), 6) << cell(within(&Errors::within_heading), 6);
}

void follow_all(const Plan& plan, const localization::LocalizationSettings& settings) {
    const std::string errors = "  ATE med  ATE max    worst  NEES xy      yaw    in    in";
    std::cout << "follow            drives  map ATE     against the truth:" << std::string(33, ' ')
              << "     in the map:\n"
              << std::string(33, ' ') << errors << errors << "    sure   ms/upd  particles  mapping\n";
    for (const std::string& name : plan.followed) {
        const Place place = place_of(name);
        const MadeMap map = made_map(plan, place);
        if (!plan.folder.empty()) {
            write_map(made_folder(plan.folder), place, map);
        }
        std::vector<Followed> drives;
        std::vector<double> sure, cpu, particles, mapping;
        for (std::size_t drive = 0; drive < plan.drives; ++drive) {
            const std::vector<SensorFrame> frames = frames_of(drive_of(place, 2 + drive));
            if (!plan.folder.empty()) {
                write_drive(plan.folder, place, map, 2 + drive, frames);
            }
            drives.push_back(follow(map, frames, settings));
            if (plan.with_mapping) {
                mapping.push_back(map_of(frames).ate_from_start_m);
            }
            sure.push_back(drives.back().sure_share);
            cpu.push_back(drives.back().cpu_ms);
            particles.push_back(drives.back().particles);
        }
        std::cout << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ')
                  << cell(std::to_string(plan.drives), 8) << cell(fixed_text(map.ate_m, 3), 9);
        print_errors(drives, &Followed::in_building);
        print_errors(drives, &Followed::in_map);
        std::cout << cell(fixed_text(median(sure), 2), 8) << cell(fixed_text(median(cpu), 2), 9)
                  << cell(fixed_text(median(particles), 0), 11)
                  << cell(mapping.empty() ? "-" : fixed_text(median(mapping), 3), 9) << std::endl;
    }
}

void start_all(const Plan& plan, const localization::LocalizationSettings& settings) {
    std::cout << "\nstart             starts   right  sure and right  way med  way max  sure and wrong\n";
    for (const std::string& name : plan.started) {
        const Place place = place_of(name);
        const MadeMap map = made_map(plan, place);
        std::size_t right = 0, sure = 0, wrong = 0;
        std::vector<double> ways;
        std::vector<SensorFrame> frames;
        for (std::size_t start = 0; start < plan.starts; ++start) {
            constexpr std::size_t starts_per_drive = 20;
            if (start % starts_per_drive == 0) {
                frames = frames_of(drive_of(place, 2 + start / starts_per_drive));
            }
            RandomStream random({11, start});
            const Started one = start_anywhere(map, frames, random.index(frames.size() * 8 / 10), plan.way_m, settings);
            right += one.right ? 1 : 0;
            wrong += one.confidently_wrong ? 1 : 0;
            if (one.right_after_m) {
                ++sure;
                ways.push_back(*one.right_after_m);
            }
        }
        std::cout << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ')
                  << cell(std::to_string(plan.starts), 8) << cell(std::to_string(right), 8)
                  << cell(std::to_string(sure), 16) << cell(fixed_text(median(ways), 2), 9)
                  << cell(ways.empty() ? "-" : fixed_text(*std::ranges::max_element(ways), 2), 9)
                  << cell(std::to_string(wrong), 16) << std::endl;
    }
}

void kidnap_all(const Plan& plan, const localization::LocalizationSettings& settings) {
    std::cout << "\nkidnap            times  noticed in 2 m  way med  mended  way med\n";
    for (const std::string& name : plan.started) {
        const Place place = place_of(name);
        const MadeMap map = made_map(plan, place);
        std::size_t noticed = 0, mended = 0;
        std::vector<double> notice_ways, mend_ways;
        std::vector<SensorFrame> frames;
        for (std::size_t time = 0; time < plan.kidnappings; ++time) {
            constexpr std::size_t times_per_drive = 10;
            if (time % times_per_drive == 0) {
                frames = frames_of(drive_of(place, 2 + time / times_per_drive));
            }
            RandomStream random({13, time});
            const std::size_t from = random.index(frames.size() * 8 / 10);
            std::size_t to = from;
            constexpr double least_m = 3.0;
            while (distance_m(*frames[from].world_from_robot, *frames[to].world_from_robot) < least_m) {
                to = random.index(frames.size() * 8 / 10);
            }
            const Kidnapped one = kidnap(map, frames, from, to, plan.way_m, settings);
            constexpr double soon_m = 2.0;
            noticed += one.noticed_after_m && *one.noticed_after_m <= soon_m ? 1 : 0;
            if (one.noticed_after_m) {
                notice_ways.push_back(*one.noticed_after_m);
            }
            if (one.mended_after_m) {
                ++mended;
                mend_ways.push_back(*one.mended_after_m);
            }
        }
        std::cout << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ')
                  << cell(std::to_string(plan.kidnappings), 7) << cell(std::to_string(noticed), 16)
                  << cell(fixed_text(median(notice_ways), 2), 9) << cell(std::to_string(mended), 8)
                  << cell(fixed_text(median(mend_ways), 2), 9) << std::endl;
    }
}

void run(Plan plan) {
    if (plan.quick) {
        plan.followed = plan.started = {"ring@8"};
        plan.drives = plan.starts = plan.kidnappings = 1;
    }
    Json json = localization::default_localization_json();
    for (const std::string& setting : plan.settings) {
        merge_assignment(json, setting);
    }
    const localization::LocalizationSettings settings = localization::localization_from_json(json);
    follow_all(plan, settings);
    start_all(plan, settings);
    kidnap_all(plan, settings);
}

}  // namespace
}  // namespace ddtool::localization_bench

int main(int argc, char** argv) {
    CLI::App app("Localises drives through simulated worlds in maps of other drives, and compares with the truth");
    ddtool::localization_bench::Plan plan;
    app.add_option("--follow", plan.followed, "Worlds to follow drives in; NAME@M: with a lidar of so many metres")
        ->delimiter(',')
        ->expected(0, 100);
    app.add_option("--start", plan.started, "Worlds to start in without a pose, and to be kidnapped in")
        ->delimiter(',')
        ->expected(0, 100);
    app.add_option("--drives", plan.drives, "Drives to follow in each world")->capture_default_str();
    app.add_option("--starts", plan.starts, "Starts in each world")->capture_default_str();
    app.add_option("--kidnappings", plan.kidnappings, "Kidnappings in each world")->capture_default_str();
    app.add_option("--way", plan.way_m, "Metres driven after a start or a kidnapping")->capture_default_str();
    app.add_option("--set", plan.settings, "A setting, such as localization.kld_error=0.05; may be repeated");
    app.add_option("--write", plan.folder,
                   "Folder for the followed maps and drives as text, to measure other programs");
    app.add_flag("--true-maps", plan.true_maps, "Maps drawn at the true poses, without the errors of mapping");
    app.add_flag("--with-mapping", plan.with_mapping,
                 "Also the ATE of the followed drives from their start when they are mapped");
    app.add_flag("--quick", plan.quick, "One trial of each kind, to see that the bench works");
    CLI11_PARSE(app, argc, argv);
    try {
        ddtool::localization_bench::run(plan);
    } catch (const std::exception& error) {
        std::cerr << "bench_localize: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
