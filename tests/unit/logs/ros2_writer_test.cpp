#include "logs/ros2_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "logs/log_stream.hpp"
#include "logs/ros_conversions.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

LaserScan some_scan(std::int64_t stamp_ns) {
    LaserScan scan;
    scan.stamp_ns = stamp_ns;
    scan.angle_min_rad = 1.5;
    scan.angle_increment_rad = -0.25;
    scan.range_min_m = 0.125;
    scan.range_max_m = 30.0;
    scan.ranges_m = {1.0F, LaserScan::no_return, LaserScan::invalid, 29.0F};
    return scan;
}

void write_log(const std::filesystem::path& path) {
    Ros2Writer writer(path);
    writer.write("/tf_static", 0, ros::transform_message(0, "base", "laser", {0.5, 0.25, 1.0}));
    for (std::int64_t i = 1; i <= 5; ++i) {
        const Pose2 pose{0.1 * static_cast<double>(i), -0.2, 0.3};
        writer.write("/odom", i, ros::odometry_message(i, "odom", "base", pose));
        writer.write("/ground_truth", i, ros::pose_message(i, "world", pose));
        writer.write("/scan", i, ros::to_message(some_scan(i), "laser"));
    }
    writer.close();
}

TEST(Ros2Writer, WhatItWritesIsReadBackAsALog) {
    const test::TemporaryFolder folder;
    write_log(folder / "log.mcap");
    const auto stream = open_log(folder / "log.mcap", {}, [](const LogProblem& problem) { FAIL() << problem.what; });
    for (std::int64_t i = 1; i <= 5; ++i) {
        const auto frame = stream->next();
        ASSERT_TRUE(frame);
        const LaserScan expected = some_scan(i);
        EXPECT_EQ(frame->scan.stamp_ns, i);
        EXPECT_EQ(frame->scan.angle_min_rad, expected.angle_min_rad);
        EXPECT_EQ(frame->scan.angle_increment_rad, expected.angle_increment_rad);
        EXPECT_EQ(frame->scan.range_max_m, expected.range_max_m);
        EXPECT_EQ(frame->scan.ranges_m[0], 1.0F);
        EXPECT_EQ(frame->scan.ranges_m[1], LaserScan::no_return);
        EXPECT_TRUE(std::isnan(frame->scan.ranges_m[2]));
        EXPECT_NEAR(frame->odom_from_robot.x_m, 0.1 * static_cast<double>(i), 1e-12);
        EXPECT_NEAR(frame->odom_from_robot.theta_rad, 0.3, 1e-12);
        EXPECT_NEAR(frame->robot_from_laser.theta_rad, 1.0, 1e-12);
        ASSERT_TRUE(frame->world_from_robot);
        EXPECT_NEAR(distance_m(*frame->world_from_robot, frame->odom_from_robot), 0.0, 1e-12);
    }
    EXPECT_FALSE(stream->next());
    EXPECT_TRUE(stream->summary().assumptions.empty());
    EXPECT_EQ(stream->summary().odometry, 5U);
    EXPECT_EQ(stream->summary().ground_truth, 5U);
}

TEST(Ros2Writer, LeavesNothingWithoutClose) {
    const test::TemporaryFolder folder;
    { Ros2Writer(folder / "log.mcap").write("/pose", 1, ros::pose_message(1, "map", {})); }
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
