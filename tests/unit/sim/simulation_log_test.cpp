#include "sim/simulation_log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/messages/ros_codec.hpp"
#include "sim/simulated_stream.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool::sim {
namespace {

World short_drive() {
    World world;
    add_box(world, {}, 10.0, 6.0);
    world.route = {.start = {-2.0, 0.0, 0.3}, .way_points = {{2.0, 1.0}, {-1.0, -1.0}}};
    return world;
}

SimulationSettings logged_settings() {
    SimulationSettings settings;
    settings.lidar.beams = 45;
    settings.lidar.motion_distortion = true;
    settings.robot_from_laser = {0.1, -0.05, 0.4};
    return settings;
}

std::filesystem::path write_log(const test::TemporaryFolder& folder, const std::string& name) {
    const std::filesystem::path file = folder / name;
    write_simulation_log(Simulation(short_drive(), logged_settings()), file, [](std::size_t) {});
    return file;
}

void expect_near(const Pose2& pose, const Pose2& expected) {
    EXPECT_NEAR(distance_m(pose, expected), 0.0, 1e-9);
    EXPECT_NEAR(wrap_angle(pose.theta_rad - expected.theta_rad), 0.0, 1e-9);
}

void expect_same_scan(const LaserScan& scan, const LaserScan& expected) {
    EXPECT_EQ(scan.stamp_ns, expected.stamp_ns);
    EXPECT_NEAR(scan.angle_increment_rad, expected.angle_increment_rad, 1e-7);
    EXPECT_NEAR(scan.time_increment_s, expected.time_increment_s, 1e-9);
    ASSERT_EQ(scan.ranges_m.size(), expected.ranges_m.size());
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        EXPECT_TRUE(scan.ranges_m[beam] == expected.ranges_m[beam] ||
                    (std::isnan(scan.ranges_m[beam]) && std::isnan(expected.ranges_m[beam])));
    }
}

TEST(SimulationLog, HoldsTheGyroWhoseTurnsAreBetterThanThoseOfBadWheels) {
    World world = short_drive();
    world.route.laps = 5;
    SimulationSettings settings = logged_settings();
    settings.lidar.beams = 180;
    settings.odometry.turn_error = 0.08;
    settings.imu.rate_hz = 100.0;
    const test::TemporaryFolder folder;
    write_simulation_log(Simulation(world, settings), folder / "drive.mcap", [](std::size_t) {});
    const auto log = open_log(folder / "drive.mcap", {}, {});
    EXPECT_EQ(log->summary().imu_topic, "/imu");
    EXPECT_EQ(log->summary().problems, 0U);
}

/// A log that was written and read back must give the same frames as the simulation in memory.
TEST(SimulationLog, ReadsBackAsTheSimulatedStream) {
    const test::TemporaryFolder folder;
    const auto log = open_log(write_log(folder, "drive.mcap"), {}, {});
    SimulatedStream stream(short_drive(), logged_settings());
    const auto told_by_log = std::make_shared<ScanTruth>();
    const auto told_by_stream = std::make_shared<ScanTruth>();
    log->tell_truth(told_by_log);
    stream.tell_truth(told_by_stream);
    std::size_t count = 0;
    while (const std::optional<SensorFrame> expected = stream.next()) {
        const std::optional<SensorFrame> frame = log->next();
        ASSERT_TRUE(frame) << "after " << count;
        expect_same_scan(frame->scan, expected->scan);
        expect_near(frame->robot_from_laser, expected->robot_from_laser);
        expect_near(frame->odom_from_robot, expected->odom_from_robot);
        ASSERT_TRUE(frame->world_from_robot);
        expect_near(*frame->world_from_robot, *expected->world_from_robot);
        const auto information = told_by_log->fisher_information(frame->scan.stamp_ns);
        ASSERT_TRUE(information);
        EXPECT_EQ(information, told_by_stream->fisher_information(expected->scan.stamp_ns));
        ++count;
    }
    EXPECT_FALSE(log->next());
    EXPECT_GT(count, 50U);
    EXPECT_EQ(log->summary().problems, 0U);
}

TEST(SimulationLog, HoldsTheFisherInformationOfEveryScanAtItsStamp) {
    const test::TemporaryFolder folder;
    const Simulation simulation(short_drive(), logged_settings());
    McapReader reader(write_log(folder, "drive.mcap"), {});
    std::size_t index = 0;
    while (const std::optional<McapMessage> message = reader.next()) {
        if (message->channel->topic != "/fisher_information") {
            continue;
        }
        const SimulatedFrame expected = simulation.frame(index++);
        EXPECT_EQ(message->log_time_ns, expected.frame.scan.stamp_ns);
        const auto matrix = decode_cdr<RosFloat64MultiArray>(message->data);
        ASSERT_TRUE(matrix);
        ASSERT_EQ(matrix->data.size(), 9U);
        EXPECT_EQ(matrix->data[5], expected.fisher_information(1, 2));
        EXPECT_EQ(matrix->data[0], expected.fisher_information(0, 0));
    }
    EXPECT_EQ(index, simulation.frame_count());
}

TEST(SimulationLog, HasTheScansOfAllLidars) {
    const test::TemporaryFolder folder;
    SimulationSettings settings = logged_settings();
    settings.more_lasers = {{-0.2, 0.0, 3.0}};
    const Simulation simulation(short_drive(), settings);
    write_simulation_log(simulation, folder / "two.mcap", [](std::size_t) {});
    LogOptions options;
    options.scan_topic = "/scan,/scan_2";
    const auto log = open_log(folder / "two.mcap", options, {});
    std::array<std::size_t, 2> count{};
    while (const std::optional<SensorFrame> frame = log->next()) {
        const SimulatedFrame expected = simulation.frame(count.at(frame->lidar)++, frame->lidar);
        expect_same_scan(frame->scan, expected.frame.scan);
        expect_near(frame->robot_from_laser, expected.frame.robot_from_laser);
        expect_near(frame->odom_from_robot, expected.frame.odom_from_robot);
    }
    EXPECT_EQ(count[0], simulation.frame_count());
    EXPECT_EQ(count[1], simulation.frame_count(1));
    EXPECT_EQ(log->summary().problems, 0U);
}

TEST(SimulationLog, IsTheSameBytesTwice) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(read_file(write_log(folder, "one.mcap")), read_file(write_log(folder, "two.mcap")));
}

}  // namespace
}  // namespace ddtool::sim
