#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <string>

#include "ddtool/system/settings.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/messages/ros_codec.hpp"
#include "mcap_read_back.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::test {
namespace {

const std::filesystem::path ros2_samples = DDTOOL_MCAP_SAMPLES;

/// Compares the messages in ros2.mcap, which @foxglove/rosmsg2-serialization encoded, with the values that it was
/// given.
class Ros2Sample : public testing::Test {
protected:
    Ros2Sample() {
        for (const OwnedMessage& message : read_back(ByteSource(ros2_samples / "ros2.mcap")).messages) {
            messages_[message.channel.topic] = message;
        }
        for (const Json& one : Json::parse(read_file(ros2_samples / "ros2_expected.json"))) {
            expected_[one.at("topic")] = one.at("message");
        }
    }

    template <typename Message>
    Message decode(const std::string& topic) {
        const OwnedMessage& message = messages_.at(topic);
        EXPECT_EQ(message.channel.schema.name, Message::type_name);
        const auto decoded = decode_cdr<Message>(std::as_bytes(std::span(message.data)));
        EXPECT_TRUE(decoded);
        return decoded.value_or(Message{});
    }
    const Json& expected(const std::string& topic) { return expected_.at(topic); }

private:
    std::map<std::string, OwnedMessage> messages_;
    std::map<std::string, Json> expected_;
};

void expect_vector(const RosVector3& vector, const Json& json) {
    EXPECT_EQ((Json{{"x", vector.x}, {"y", vector.y}, {"z", vector.z}}), json);
}

void expect_pose(const RosPose& pose, const Json& position, const Json& orientation) {
    expect_vector(pose.position, position);
    EXPECT_EQ((Json{{"x", pose.orientation.x},
                    {"y", pose.orientation.y},
                    {"z", pose.orientation.z},
                    {"w", pose.orientation.w}}),
              orientation);
}

void expect_header(const RosHeader& header, const Json& json) {
    const Json& stamp = json.at("stamp");
    EXPECT_EQ(header.stamp.ns,
              stamp.at("sec").get<std::int64_t>() * 1'000'000'000 + stamp.at("nanosec").get<std::int64_t>());
    EXPECT_EQ(header.frame_id, json.at("frame_id"));
}

TEST_F(Ros2Sample, LaserScan) {
    const auto scan = decode<RosLaserScan>("/scan");
    const Json& json = expected("/scan");
    expect_header(scan.header, json.at("header"));
    EXPECT_EQ(scan.angle_min, json.at("angle_min"));
    EXPECT_EQ(scan.angle_max, json.at("angle_max"));
    EXPECT_EQ(scan.angle_increment, json.at("angle_increment"));
    EXPECT_EQ(scan.time_increment, json.at("time_increment"));
    EXPECT_EQ(scan.scan_time, json.at("scan_time"));
    EXPECT_EQ(scan.range_min, json.at("range_min"));
    EXPECT_EQ(scan.range_max, json.at("range_max"));
    EXPECT_EQ(Json(scan.ranges), json.at("ranges"));
    EXPECT_EQ(Json(scan.intensities), json.at("intensities"));
}

TEST_F(Ros2Sample, Odometry) {
    const auto odometry = decode<RosOdometry>("/odom");
    const Json& json = expected("/odom");
    const Json& pose = json.at("pose");
    const Json& twist = json.at("twist");
    expect_header(odometry.header, json.at("header"));
    EXPECT_EQ(odometry.child_frame_id, json.at("child_frame_id"));
    expect_pose(odometry.pose, pose.at("pose").at("position"), pose.at("pose").at("orientation"));
    EXPECT_EQ(Json(odometry.pose_covariance), pose.at("covariance"));
    expect_vector(odometry.linear_velocity, twist.at("twist").at("linear"));
    expect_vector(odometry.angular_velocity, twist.at("twist").at("angular"));
    EXPECT_EQ(Json(odometry.velocity_covariance), twist.at("covariance"));
}

TEST_F(Ros2Sample, Transforms) {
    for (const std::string topic : {"/tf", "/tf_static"}) {
        const auto message = decode<RosTFMessage>(topic);
        const Json& transforms = expected(topic).at("transforms");
        ASSERT_EQ(message.transforms.size(), transforms.size());
        for (std::size_t index = 0; index < transforms.size(); ++index) {
            const Json& json = transforms[index];
            expect_header(message.transforms[index].header, json.at("header"));
            EXPECT_EQ(message.transforms[index].child_frame_id, json.at("child_frame_id"));
            expect_pose(message.transforms[index].transform, json.at("transform").at("translation"),
                        json.at("transform").at("rotation"));
        }
    }
}

TEST_F(Ros2Sample, PoseStamped) {
    const auto truth = decode<RosPoseStamped>("/truth");
    const Json& json = expected("/truth");
    expect_header(truth.header, json.at("header"));
    expect_pose(truth.pose, json.at("pose").at("position"), json.at("pose").at("orientation"));
}

}  // namespace
}  // namespace ddtool::test
