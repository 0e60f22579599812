/// What the product promises, on short drives: every method stays usable everywhere, and where the lidar leaves the way
/// open the default method is far better than the plain filter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "ddtool/methods/method.hpp"
#include "room_scans.hpp"
#include "scores/absolute_error.hpp"
#include "scores/statistics.hpp"
#include "sim/simulated_stream.hpp"

namespace ddtool {
namespace {

constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};

sim::World with_route(sim::World world, const Pose2& start, std::vector<Point2> way_points) {
    world.route = {.start = start, .way_points = std::move(way_points), .laps = 1.0};
    return world;
}

/// Something to hold on to in every direction, everywhere.
sim::World a_room() {
    return with_route(furnished_room(), {-1.0, 0.0, 0.0}, {{1.5, -1.0}, {1.5, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}});
}

/// Its ends are out of range for most of the way.
sim::World a_corridor() { return with_route(room(60.0, 2.2), {-27.0, 0.0, 0.0}, {{27.0, 0.0}}); }

/// From one yard to the other over ground where nothing is in range.
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
    settings.lidar.beams = 360;
    settings.lidar.rate_hz = 5.0;
    settings.lidar.range_max_m = 8.0;
    settings.odometry = sim::odometry_preset("poor");
    return settings;
}

/// The root mean square error of the path (ATE), the median over the seeds.
double error_m(const sim::World& world, const MethodSettings& method) {
    std::vector<double> errors_m;
    for (const std::uint64_t seed : seeds) {
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

double error_m(const sim::World& world, const std::string& method) {
    MethodSettings settings;
    settings.method = method;
    const double error = error_m(world, settings);
    testing::Test::RecordProperty(method, std::to_string(error));
    return error;
}

TEST(Places, InARoomEveryMethodKnowsWhereItIs) {
    for (const std::string& method : method_names()) {
        EXPECT_LT(error_m(a_room(), method), method == "odometry" ? 0.3 : 0.05) << method;
    }
}

TEST(Places, InARoomTheDefaultIsAsGoodAsThePlainFilter) {
    EXPECT_LT(error_m(a_room(), MethodSettings{}), error_m(a_room(), "gmapping") + 0.005);
}

TEST(Places, InACorridorTheDefaultIsFarBetterThanThePlainFilter) {
    EXPECT_LT(error_m(a_corridor(), MethodSettings{}), 0.5 * error_m(a_corridor(), "gmapping"));
}

TEST(Places, OnOpenGroundTheDefaultIsFarBetterThanThePlainFilter) {
    EXPECT_LT(error_m(open_ground(), MethodSettings{}), 0.5 * error_m(open_ground(), "gmapping"));
}

TEST(Places, WhereTheLidarLeavesTheWayOpenNoMethodLosesTheRobot) {
    for (const std::string& method : method_names()) {
        EXPECT_LT(error_m(a_corridor(), method), 5.0) << method;
        EXPECT_LT(error_m(open_ground(), method), 15.0) << method;
    }
}

}  // namespace
}  // namespace ddtool
