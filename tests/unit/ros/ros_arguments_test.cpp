#include "ros/ros_arguments.hpp"

#include <gmock/gmock.h>

#include <map>

#include "ddtool/base/error.hpp"
#include "ros/ros_environment.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;

TEST(RosArguments, GiveTopicsOtherNames) {
    const RosArguments arguments = parse_ros_arguments({"-r", "scan:=/front/scan", "--remap", "/tf:=tf"});
    EXPECT_EQ(resolved_topic(arguments, "scan"), "/front/scan");
    EXPECT_EQ(resolved_topic(arguments, "/scan"), "/front/scan");
    EXPECT_EQ(resolved_topic(arguments, "odom"), "/odom");
    EXPECT_EQ(resolved_topic(arguments, "/tf"), "/tf");
}

TEST(RosArguments, PutTopicsIntoANamespace) {
    const RosArguments arguments =
        parse_ros_arguments({"-r", "__ns:=/robot1", "-r", "__node:=mapper", "-r", "/tf:=tf", "-r", "map:=~/map"});
    EXPECT_EQ(arguments.name_space, "/robot1");
    EXPECT_EQ(arguments.node, "mapper");
    EXPECT_EQ(resolved_topic(arguments, "scan"), "/robot1/scan");
    EXPECT_EQ(resolved_topic(arguments, "/tf"), "/robot1/tf");
    EXPECT_EQ(resolved_topic(arguments, "/tf_static"), "/tf_static");
    EXPECT_EQ(resolved_topic(arguments, "map"), "/robot1/mapper/map");
}

TEST(RosArguments, ForAnotherNodeHaveNoEffect) {
    const RosArguments arguments = parse_ros_arguments({"-r", "other:scan:=/a", "-r", "ddtool:odom:=/b"});
    EXPECT_EQ(resolved_topic(arguments, "scan"), "/scan");
    EXPECT_EQ(resolved_topic(arguments, "odom"), "/b");
}

TEST(RosArguments, HaveParameters) {
    const RosArguments arguments =
        parse_ros_arguments({"-p", "use_sim_time:=true", "--param", "transform_tolerance:=0.5"});
    EXPECT_TRUE(arguments.use_sim_time);
    EXPECT_EQ(arguments.transform_tolerance_s, 0.5);
}

TEST(RosArguments, AreRefusedWithWhatWasExpected) {
    const auto refusal = [](const std::vector<std::string>& words) {
        return test::thrown_text<UsageError>([&] { parse_ros_arguments(words); });
    };
    EXPECT_THAT(refusal({"scan:=/a"}), HasSubstr("expected -r FROM:=TO"));
    EXPECT_THAT(refusal({"-r"}), HasSubstr("after it"));
    EXPECT_THAT(refusal({"-r", "scan=/a"}), HasSubstr("'scan=/a': expected FROM:=TO"));
    EXPECT_THAT(refusal({"-r", "scan:=/a b"}), HasSubstr("'/a b' is no name of ROS 2"));
    EXPECT_THAT(refusal({"-r", "__ns:=/9"}), HasSubstr("'/9' is no name of ROS 2"));
    EXPECT_THAT(refusal({"-p", "use_sim_time:=yes"}), HasSubstr("expected true or false"));
    EXPECT_THAT(refusal({"-p", "transform_tolerance:=nan"}), HasSubstr("expected seconds from 0 to 10"));
    EXPECT_THAT(refusal({"-p", "frequency:=4"}), HasSubstr("expected use_sim_time or transform_tolerance"));
}

RosEnvironment environment_of(const std::map<std::string, std::string>& variables) {
    return ros_environment([&](const char* name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

TEST(RosEnvironment, IsThatOfARos2Program) {
    const RosEnvironment bare = environment_of({});
    EXPECT_EQ(bare.domain, 0U);
    EXPECT_FALSE(bare.loopback_only);
    EXPECT_EQ(bare.gid_bytes, 16U);
    EXPECT_EQ(environment_of({{"ROS_DOMAIN_ID", "42"}}).domain, 42U);
    EXPECT_TRUE(environment_of({{"ROS_LOCALHOST_ONLY", "1"}}).loopback_only);
    EXPECT_FALSE(environment_of({{"ROS_LOCALHOST_ONLY", "0"}}).loopback_only);
    EXPECT_TRUE(environment_of({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST"}}).loopback_only);
    EXPECT_TRUE(environment_of({{"ROS_LOCALHOST_ONLY", "1"}, {"ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"}}).loopback_only);
    EXPECT_EQ(environment_of({{"ROS_DISTRO", "humble"}}).gid_bytes, 24U);
    EXPECT_EQ(environment_of({{"ROS_DISTRO", "jazzy"}}).gid_bytes, 16U);
    EXPECT_THAT(environment_of({{"ROS_STATIC_PEERS", "10.0.0.7;robot.local;"}}).peers,
                testing::ElementsAre("10.0.0.7", "robot.local"));
}

TEST(RosEnvironment, IsRefusedWithWhatWasExpected) {
    const auto refusal = [](const std::map<std::string, std::string>& variables) {
        return test::thrown_text<UsageError>([&] { environment_of(variables); });
    };
    EXPECT_THAT(refusal({{"ROS_DOMAIN_ID", "233"}}), HasSubstr("ROS_DOMAIN_ID=233: expected a number from 0 to 232"));
    EXPECT_THAT(refusal({{"ROS_DOMAIN_ID", "one"}}), HasSubstr("expected a number"));
    EXPECT_THAT(refusal({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"}}), HasSubstr("no robot can be found"));
    EXPECT_THAT(refusal({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "WORLD"}}), HasSubstr("expected SUBNET"));
}

}  // namespace
}  // namespace ddtool
