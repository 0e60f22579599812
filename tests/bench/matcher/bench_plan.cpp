#include "bench_plan.hpp"

#include <utility>

#include "bench_worlds.hpp"
#include "drive_through.hpp"

namespace ddtool::matcher_bench {
namespace {

/// A drive through one layout, and for a map that is known another one with other noise.
struct Drive {
    std::uint64_t seed = 0;  ///< of all that is drawn in it
    std::vector<Place> places;
    std::vector<Place> before;
};

constexpr std::uint64_t other_noise = 1'000'000;

std::vector<Drive> drives_of(const Plan& plan, const std::string& kind, const sim::LidarSettings& lidar) {
    const RbpfSettings& filter = plan.trials.filter;
    std::vector<Drive> drives;
    for (std::uint64_t layout = 1; layout <= plan.layouts; ++layout) {
        const BenchWorld world = draw_world(kind, layout, plan.length_m);
        const std::uint64_t seed = plan.trials.seed + layout;
        Drive drive{seed, drive_through(world, lidar, filter, seed), {}};
        if (plan.known_map) {
            drive.before = drive_through(world, lidar, filter, seed + other_noise);
        }
        drives.push_back(std::move(drive));
    }
    return drives;
}

Summary measure(const std::vector<Drive>& drives, bool known_map, TrialSettings settings) {
    std::vector<std::vector<Trial>> trials;
    std::vector<double> drifts;
    for (const Drive& drive : drives) {
        settings.seed = drive.seed;
        trials.push_back(known_map ? match_in_known_map(drive.before, drive.places, settings)
                                   : match_at_frontier(drive.places, settings));
        if (!known_map) {
            drifts.push_back(drift(drive.places, settings));
        }
    }
    return summarise(trials, drifts, settings.filter);
}

}  // namespace

std::vector<CaseResult> run_plan(const Plan& plan, const std::function<void(const CaseResult&)>& done) {
    std::vector<CaseResult> results;
    for (const std::string& world : plan.worlds) {
        for (const sim::LidarSettings& lidar : plan.lidars) {
            const std::vector<Drive> drives = drives_of(plan, world, lidar);
            for (const double cell_size_m : plan.cell_sizes_m) {
                TrialSettings settings = plan.trials;
                settings.filter.grid.cell_size_m = cell_size_m;
                results.push_back({world, lidar, cell_size_m, measure(drives, plan.known_map, settings)});
                done(results.back());
            }
        }
    }
    return results;
}

}  // namespace ddtool::matcher_bench
