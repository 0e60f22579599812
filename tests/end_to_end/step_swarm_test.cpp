// Measures what the canvas of the step swarm was chosen by: the filter itself in a room and in a corridor, with short
// and long steps. Prints the figures of docs/reports/2026-11-22-particle-images.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/world_catalogue.hpp"
#include "swarm/rules.hpp"

namespace ddtool {
namespace {

struct Spreads {
    double predicted_m = 0.0;  ///< both are medians over the updates
    double matched_m = 0.0;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// The spreads of the steps in the first minute of a drive through the world.
Spreads step_spreads(const std::string& world, double update_distance_m) {
    ThreadPool threads(1);
    RbpfSettings settings;
    settings.update_distance_m = update_distance_m;
    Rbpf filter(settings, threads);
    std::vector<double> predicted;
    std::vector<double> matched;
    sim::SimulatedStream stream(sim::load_world(world), {});
    for (int scan = 0; scan < 720; ++scan) {
        if (const auto update = filter.update(*stream.next())) {
            predicted.push_back(spread_m(update->matched.particles, &SnapshotParticle::predicted_motion));
            matched.push_back(spread_m(update->matched.particles, &SnapshotParticle::matched_motion));
        }
    }
    return {median(predicted), median(matched)};
}

TEST(StepSwarm, IsAsWideAsPredictedInACorridorAndThinInARoomHoweverLongTheSteps) {
    std::printf("| world | update every | predicted | matched | on 8 predicted spreads | on 1 m |\n");
    for (const double distance_m : {0.1, 0.5}) {
        for (const char* world : {"s1", "s2"}) {
            const Spreads spreads = step_spreads(world, distance_m);
            const double share = spreads.matched_m / spreads.predicted_m;
            std::printf("| %s | %.1f m | %.3f m | %.4f m | %.1f px | %.1f px |\n", world, distance_m,
                        spreads.predicted_m, spreads.matched_m, share * 224.0 / 8.0, spreads.matched_m * 224.0);
            const bool corridor = std::string(world) == "s2";
            EXPECT_GT(share, corridor ? 0.7 : 0.0);
            EXPECT_LT(share, corridor ? 1.3 : 0.2);
        }
    }
}

}  // namespace
}  // namespace ddtool
