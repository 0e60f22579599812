#include "sim/simulation.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/robot/scan_points.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/world_catalogue.hpp"

namespace ddtool::sim {
namespace {

SimulationSettings small_settings() {
    SimulationSettings settings;
    settings.lidar.beams = 90;
    settings.robot_from_laser = {0.1, 0.0, 0.2};
    return settings;
}

std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) {
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return bits;
}

/// Compares the bits, so that NaN values are equal as well.
void expect_same_bytes(const SimulatedFrame& a, const SimulatedFrame& b) {
    EXPECT_EQ(bits_of(a.frame.scan.ranges_m), bits_of(b.frame.scan.ranges_m));
    EXPECT_EQ(a.frame.scan.stamp_ns, b.frame.scan.stamp_ns);
    EXPECT_EQ(a.frame.odom_from_robot, b.frame.odom_from_robot);
    EXPECT_EQ(a.frame.world_from_robot, b.frame.world_from_robot);
    EXPECT_EQ(a.fisher_information, b.fisher_information);
}

TEST(Simulation, IsTheSameBytesTwiceAndOnManyThreads) {
    const World world = load_world("s1");
    const Simulation one(world, small_settings());
    const Simulation other(world, small_settings());
    ASSERT_EQ(one.frame_count(), other.frame_count());
    std::vector<SimulatedFrame> frames(one.frame_count());
    ThreadPool pool(3);
    pool.for_each(frames.size(), [&](std::size_t i, std::size_t) { frames[i] = other.frame(i); });
    for (std::size_t i = 0; i < frames.size(); ++i) {
        expect_same_bytes(one.frame(i), frames[i]);
    }
}

TEST(Simulation, SeedsDifferInNoiseAndNotInTheWay) {
    const World world = load_world("s1");
    SimulationSettings settings = small_settings();
    const SimulatedFrame one = Simulation(world, settings).frame(100);
    settings.seed = 2;
    const SimulatedFrame two = Simulation(world, settings).frame(100);
    EXPECT_EQ(one.frame.world_from_robot, two.frame.world_from_robot);
    EXPECT_NE(one.frame.odom_from_robot, two.frame.odom_from_robot);
    EXPECT_NE(bits_of(one.frame.scan.ranges_m), bits_of(two.frame.scan.ranges_m));
}

TEST(Simulation, ScansComeAtTheirRateWithinTheDrive) {
    const Simulation simulation(load_world("r1"), small_settings());
    const std::size_t last = simulation.frame_count() - 1;
    const std::int64_t stamp_ns = simulation.frame(last).frame.scan.stamp_ns;
    EXPECT_LE(stamp_ns, simulation.truth().back().stamp_ns);
    EXPECT_GT(stamp_ns, simulation.truth().back().stamp_ns - 100'000'000);
    EXPECT_NEAR(1e-9 * static_cast<double>(stamp_ns - simulation.truth().front().stamp_ns),
                static_cast<double>(last) / 12.0, 1e-8);
}

/// The end point of every beam, computed from the true pose, must lie on a wall.
TEST(Simulation, BeamsEndOnTheWallsSeenFromTheTruePose) {
    World world;
    add_box(world, {}, 10.0, 10.0);
    world.route = {.start = {-2.0, 0.0, 0.5}, .way_points = {{2.0, 1.0}}};
    SimulationSettings settings = small_settings();
    settings.lidar.range_noise_m = 0.0;
    settings.lidar.range_resolution_m = 0.0;
    const SensorFrame frame = Simulation(world, settings).frame(30).frame;
    for (std::size_t beam = 0; beam < frame.scan.ranges_m.size(); ++beam) {
        const double range_m = frame.scan.ranges_m[beam];
        if (std::isfinite(range_m)) {
            const double angle_rad = frame.scan.angle_rad(beam);
            const Point2 end =
                *frame.world_from_robot *
                (frame.robot_from_laser * Point2{range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)});
            EXPECT_NEAR(std::max(std::abs(end.x_m), std::abs(end.y_m)), 5.0, 1e-5);
        }
    }
}

TEST(Simulation, MotionDistortionTakesEachBeamWhereTheLaserThenWas) {
    World world;
    world.segments = {{{10.0, -50.0}, {10.0, 50.0}}};
    world.route = {.start = {}, .way_points = {{8.0, 0.0}}};
    SimulationSettings settings;
    settings.lidar = {.beams = 37,
                      .field_of_view_rad = 1.0,
                      .rate_hz = 2.0,
                      .range_noise_m = 0.0,
                      .range_resolution_m = 0.0,
                      .drop_out_probability = 0.0,
                      .motion_distortion = true};
    const Simulation simulation(world, settings);
    const SensorFrame frame = simulation.frame(8).frame;
    ASSERT_GT(frame.scan.time_increment_s, 0.0);
    for (std::size_t beam = 0; beam < frame.scan.ranges_m.size(); ++beam) {
        const auto later_ns = static_cast<std::int64_t>(1e9 * frame.scan.time_increment_s * static_cast<double>(beam));
        const double x_m = pose_at(simulation.truth(), frame.scan.stamp_ns + later_ns)->x_m;
        EXPECT_NEAR(frame.scan.ranges_m[beam], (10.0 - x_m) / std::cos(frame.scan.angle_rad(beam)), 1e-4);
    }
    EXPECT_EQ(frame.scan.scan_time_s, 0.5);
    const ScanPoints points = scan_points(frame, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(frame.world_from_robot->x_m + static_cast<double>(points.x_m[i]), 10.0, 0.01);
    }
}

TEST(SimulatedStream, GivesEveryFrameOfTheSimulationInOrder) {
    const World world = load_world("r1");
    SimulatedStream stream(world, small_settings());
    const auto truth = std::make_shared<ScanTruth>();
    stream.tell_truth(truth);
    const Simulation simulation(world, small_settings());
    std::size_t count = 0;
    while (const std::optional<SensorFrame> frame = stream.next()) {
        if (count % 200 == 0) {
            expect_same_bytes({*frame, truth->fisher_information(frame->scan.stamp_ns).value()},
                              simulation.frame(count));
        }
        ++count;
    }
    EXPECT_EQ(count, simulation.frame_count());
    EXPECT_EQ(stream.fraction_read(), 1.0);
}

}  // namespace
}  // namespace ddtool::sim
