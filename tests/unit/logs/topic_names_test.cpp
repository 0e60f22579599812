#include "logs/stream/topic_names.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

TEST(TopicNames, GroundTruthIsAWordNotAPartOfOne) {
    for (const char* name :
         {"/ground_truth", "/groundtruth/odom", "/gt", "/robot/gt_pose", "/GroundTruth", "/ground/truth"}) {
        EXPECT_TRUE(names_ground_truth(name)) << name;
    }
    for (const char* name : {"/odom", "/lightgt", "/gtx", "/truth", "/ground", ""}) {
        EXPECT_FALSE(names_ground_truth(name)) << name;
    }
}

TEST(TopicNames, KnowsOdometryStaticAndFixedFrames) {
    EXPECT_TRUE(names_odometry("/robot1/odometry/filtered"));
    EXPECT_FALSE(names_odometry("/modom"));
    EXPECT_TRUE(names_static("/tf_static"));
    EXPECT_FALSE(names_static("/tf"));
    EXPECT_TRUE(names_fixed_frame("robot1/map"));
    EXPECT_FALSE(names_fixed_frame("base_link"));
}

}  // namespace
}  // namespace ddtool
