/// Tests what the project promises, on short drives: every method works in every kind of place, and where a scan does
/// not determine the position along the path, the default method is far better than the plain filter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

#include "ddtool/methods/method.hpp"
#include "room_scans.hpp"
#include "scores/absolute_error.hpp"
#include "scores/statistics.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/world_catalogue.hpp"

namespace ddtool {
namespace {

sim::World with_route(sim::World world, const Pose2& start, std::vector<Point2> way_points) {
    world.route = {.start = start, .way_points = std::move(way_points), .laps = 1.0};
    return world;
}

/// A place in which every scan determines the pose in every direction.
sim::World a_room() {
    return with_route(furnished_room(), {-1.0, 0.0, 0.0}, {{1.5, -1.0}, {1.5, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}});
}

/// A ring of plain corridors. Along each of them the lidar does not reach an end, so only at the corners do the scans
/// determine the position along the path.
sim::World a_corridor() { return sim::load_world("r1"); }

/// Two yards, and a drive from one to the other over ground where nothing is within the lidar's range.
sim::World open_ground() {
    sim::World world;
    for (const double side : {-1.0, 1.0}) {
        sim::add_polyline(world, {{side * 18.0, 5.0}, {side * 24.0, 5.0}, {side * 24.0, -4.0}, {side * 15.0, -4.0}});
    }
    return with_route(std::move(world), {-21.0, 0.0, 0.0}, {{21.0, 0.0}});
}

sim::SimulationSettings short_sighted(std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lidar.rate_hz = 4.0;
    settings.lidar.range_max_m = 8.0;
    return settings;
}

/// The root mean square of the path's errors (ATE) in metres: the median over the seeds 1 to `seeds`.
double error_m(const sim::World& world, const MethodSettings& method, std::uint64_t seeds) {
    std::vector<double> errors_m;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        ThreadPool threads(1);
        FilterSettings settings;
        settings.method = method;
        settings.rbpf.seed = seed;
        const auto filter = make_filter(settings, DetectorTable(), threads);
        sim::SimulatedStream stream(world, short_sighted(seed));
        Trajectory truth;
        while (const auto frame = stream.next()) {
            filter->update(*frame);
            truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        }
        errors_m.push_back(absolute_trajectory_error(filter->trajectory(), truth).translation_m.rmse);
    }
    return median(errors_m);
}

double error_m(const sim::World& world, const std::string& method, std::uint64_t seeds) {
    MethodSettings settings;
    settings.method = method;
    const double error = error_m(world, settings, seeds);
    std::printf("%s: %.3f m\n", method.c_str(), error);
    return error;
}

/// Expects that the error of every method stays below most_m, that of the paper's method, whose network was trained
/// with a lidar that sees 30 m, below 10 m, and that the default method's error is far below that of the plain filter.
void expect_default_far_better(const sim::World& world, double most_m) {
    std::map<std::string, double> errors_m;
    for (const std::string& method : method_names()) {
        const bool compared = method == MethodSettings{}.method || method == "rbpf";
        errors_m[method] = error_m(world, method, compared ? 3 : 1);
        EXPECT_LT(errors_m[method], method == "paper" ? 10.0 : most_m) << method;
    }
    EXPECT_LT(errors_m.at(MethodSettings{}.method), 0.6 * errors_m.at("rbpf"));
}

TEST(Places, InARoomEveryMethodKnowsWhereItIsAndTheDefaultAsWellAsThePlainFilter) {
    std::map<std::string, double> errors_m;
    for (const std::string& method : method_names()) {
        errors_m[method] = error_m(a_room(), method, 1);
        EXPECT_LT(errors_m[method], method == "odometry" ? 0.3 : 0.05) << method;
    }
    EXPECT_LT(errors_m.at(MethodSettings{}.method), errors_m.at("rbpf") + 0.003);
}

TEST(Places, InACorridorTheDefaultIsFarBetterThanThePlainFilter) { expect_default_far_better(a_corridor(), 3.0); }

TEST(Places, OnOpenGroundTheDefaultIsFarBetterThanThePlainFilter) { expect_default_far_better(open_ground(), 10.0); }

}  // namespace
}  // namespace ddtool
