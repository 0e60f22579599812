#include "logs/stream/frame_writer.hpp"

#include <gmock/gmock.h>

#include <array>

#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

/// In these frames the stamps step back in the middle, and the third frame has no ground truth.
SensorFrame some_frame(int number) {
    constexpr std::array<std::int64_t, 5> stamps_ns{10, 20, 15, 30, 40};
    SensorFrame frame;
    frame.scan.stamp_ns = stamps_ns.at(static_cast<std::size_t>(number));
    frame.scan.angle_min_rad = 1.5;
    frame.scan.angle_increment_rad = -0.25;
    frame.scan.range_min_m = 0.125;
    frame.scan.range_max_m = 30.0;
    frame.scan.ranges_m = {1.0F + static_cast<float>(number), LaserScan::no_return, LaserScan::invalid, 29.0F};
    frame.robot_from_laser = {0.5, 0.25, 1.0};
    frame.odom_from_robot = {0.1 * number, -0.2, 0.3};
    if (number != 2) {
        frame.world_from_robot = Pose2{2.0, 0.2 * number, -0.1};
    }
    return frame;
}

void write_log(const std::filesystem::path& path) {
    FrameWriter writer(path);
    for (int number = 0; number < 5; ++number) {
        writer.write(some_frame(number));
    }
    writer.close();
}

void expect_same(const Pose2& pose, const Pose2& expected) {
    EXPECT_NEAR(distance_m(pose, expected), 0.0, 1e-9);
    EXPECT_NEAR(pose.theta_rad, expected.theta_rad, 1e-9);
}

TEST(FrameWriter, WhatItWritesIsReadBackAsTheSameFrames) {
    const test::TemporaryFolder folder;
    write_log(folder / "log.mcap");
    const auto stream = open_log(folder / "log.mcap", {}, [](const LogProblem& problem) { FAIL() << problem.what; });
    for (int number = 0; number < 5; ++number) {
        const std::optional<SensorFrame> frame = stream->next();
        ASSERT_TRUE(frame);
        const SensorFrame expected = some_frame(number);
        EXPECT_EQ(frame->scan.stamp_ns, expected.scan.stamp_ns);
        EXPECT_EQ(frame->scan.angle_min_rad, expected.scan.angle_min_rad);
        EXPECT_EQ(frame->scan.angle_increment_rad, expected.scan.angle_increment_rad);
        EXPECT_EQ(frame->scan.range_max_m, expected.scan.range_max_m);
        EXPECT_THAT(frame->scan.ranges_m, testing::Pointwise(testing::NanSensitiveFloatEq(), expected.scan.ranges_m));
        expect_same(frame->odom_from_robot, expected.odom_from_robot);
        expect_same(frame->robot_from_laser, expected.robot_from_laser);
        if (expected.world_from_robot) {
            expect_same(frame->world_from_robot.value(), *expected.world_from_robot);
        }
    }
    EXPECT_FALSE(stream->next());
    EXPECT_TRUE(stream->summary().assumptions.empty());
    EXPECT_EQ(stream->summary().odometry, 5U);
    EXPECT_EQ(stream->summary().ground_truth, 4U);
}

TEST(FrameWriter, LidarsThatAreMountedElsewhereStayApart) {
    const test::TemporaryFolder folder;
    const std::vector<Pose2> mountings{{0.3, 0.0, 0.0}, {-0.2, 0.1, 3.0}};
    {
        FrameWriter writer(folder / "log.mcap");
        for (std::size_t number = 0; number < 5; ++number) {
            SensorFrame frame = some_frame(static_cast<int>(number));
            frame.robot_from_laser = mountings[number % 2];
            frame.robot_from_laser.x_m += 1e-6 * static_cast<double>(number);
            writer.write(frame);
        }
        writer.close();
    }
    const auto stream = open_log(folder / "log.mcap", {}, [](const LogProblem& problem) { FAIL() << problem.what; });
    for (std::size_t number = 0; number < 5; ++number) {
        const Pose2 read = stream->next().value().robot_from_laser;
        EXPECT_NEAR(distance_m(read, mountings[number % 2]), 0.0, 1e-3);
        EXPECT_NEAR(read.theta_rad, mountings[number % 2].theta_rad, 1e-3);
    }
}

TEST(FrameWriter, LogTimesNeverStepBack) {
    const test::TemporaryFolder folder;
    write_log(folder / "log.mcap");
    McapReader reader(folder / "log.mcap", {});
    std::int64_t last_ns = 0;
    while (const auto message = reader.next()) {
        EXPECT_GE(message->log_time_ns, last_ns);
        last_ns = message->log_time_ns;
    }
    EXPECT_EQ(last_ns, 40);
}

TEST(Ros2Writer, LeavesNothingWithoutClose) {
    const test::TemporaryFolder folder;
    { Ros2Writer(folder / "log.mcap").write("/pose", 1, pose_message(1, "map", {})); }
    EXPECT_FALSE(std::filesystem::exists(folder / "log.mcap"));
}

TEST(OpenLog, OfAnMcapFileCutOffAnywhereGivesFramesOrOneError) {
    const test::TemporaryFolder folder;
    write_log(folder / "cut");
    for (auto length = std::filesystem::file_size(folder / "cut"); length-- > 0;) {
        std::filesystem::resize_file(folder / "cut", length);
        std::size_t problems = 0;
        try {
            const auto stream = open_log(folder / "cut", {}, [&](const LogProblem&) { ++problems; });
            while (stream->next()) {
            }
            EXPECT_GT(problems, 0U) << length;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace ddtool
