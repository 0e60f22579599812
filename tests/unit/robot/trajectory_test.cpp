#include "ddtool/robot/trajectory.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

const Trajectory line{{-10, {0.0, 0.0, 0.0}}, {0, {1.0, 0.0, 0.0}}, {20, {1.0, 4.0, 0.0}}};

TEST(PathLength, AddsUpTheWayWhateverItsDirection) {
    EXPECT_EQ(path_length_m(line), 5.0);
    EXPECT_EQ(path_length_m({line[1], line[0]}), 1.0);
    EXPECT_EQ(path_length_m({}), 0.0);
}

TEST(PoseAt, IsExactAtEachPoseAndBetweenThemOnTheLine) {
    for (const StampedPose& stamped : line) {
        EXPECT_EQ(pose_at(line, stamped.stamp_ns), stamped.pose);
    }
    EXPECT_EQ(pose_at(line, -5), (Pose2{0.5, 0.0, 0.0}));
    EXPECT_EQ(pose_at(line, 5), (Pose2{1.0, 1.0, 0.0}));
}

TEST(PoseAt, IsNoneOutside) {
    EXPECT_EQ(pose_at(line, -11), std::nullopt);
    EXPECT_EQ(pose_at(line, 21), std::nullopt);
    EXPECT_EQ(pose_at({}, 0), std::nullopt);
}

}  // namespace
}  // namespace ddtool
