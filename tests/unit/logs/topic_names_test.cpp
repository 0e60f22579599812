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

TEST(TopicNames, TransformsOfARobotHaveItsNamespace) {
    EXPECT_EQ(transform_namespace("/robot1/tf"), "/robot1");
    EXPECT_EQ(transform_namespace("/fleet/robot1/tf_static"), "/fleet/robot1");
    for (const char* name : {"/tf", "/tf_static", "tf", "/robot1/transforms", "/robot1/tf_tree"}) {
        EXPECT_EQ(transform_namespace(name), "") << name;
    }
    EXPECT_TRUE(is_in_namespace("/robot1/front/scan", "/robot1"));
    EXPECT_TRUE(is_in_namespace("/scan", ""));
    EXPECT_FALSE(is_in_namespace("/robot11/scan", "/robot1"));
}

}  // namespace
}  // namespace ddtool
