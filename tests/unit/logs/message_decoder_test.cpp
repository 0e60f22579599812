#include "logs/messages/message_decoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "ros1_writer.hpp"

namespace ddtool {
namespace {

std::optional<std::vector<PoseReading>> decoded_odometry(double x_m) {
    McapChannel channel;
    channel.topic = "/odom";
    channel.message_encoding = "cdr";
    channel.schema.name = RosOdometry::type_name;
    const std::vector<std::byte> bytes = encode_cdr(odometry_message(1, "odom", "base", {x_m, 0.0, 0.0}));
    return decode_poses({.channel = &channel, .data = bytes});
}

TEST(DecodePoses, TakesNoPlaceThatCannotBe) {
    EXPECT_TRUE(decoded_odometry(6.4e6));  // the radius of the Earth: positions may be relative to its centre
    EXPECT_FALSE(decoded_odometry(-2e9));
    EXPECT_FALSE(decoded_odometry(1e300));
    EXPECT_FALSE(decoded_odometry(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(decoded_odometry(std::numeric_limits<double>::quiet_NaN()));
}

RosMultiEchoLaserScan echoes_message() {
    RosMultiEchoLaserScan message;
    message.header = {{3'000'000'000}, "/laser"};
    message.angle_min = -1.0F;
    message.angle_increment = 0.5F;
    message.time_increment = 0.25F;
    message.range_min = 0.1F;
    message.range_max = 30.0F;
    message.ranges = {{{2.0F}}, {{1.0F, 3.0F, 5.0F}}, {}, {{4.0F, 6.0F}}};
    message.intensities = {{{10.0F}}, {{5.0F, 80.0F, 40.0F}}, {}};  // those of the last beam are missing
    return message;
}

void expect_ranges(const std::optional<ScanReading>& reading, const std::vector<float>& expected) {
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->frame_id, "laser");
    EXPECT_EQ(reading->scan.stamp_ns, 3'000'000'000);
    EXPECT_EQ(reading->scan.angle_increment_rad, 0.5);
    EXPECT_EQ(reading->scan.time_increment_s, 0.25);
    ASSERT_EQ(reading->scan.ranges_m.size(), expected.size());
    for (std::size_t beam = 0; beam < expected.size(); ++beam) {
        if (std::isnan(expected[beam])) {
            EXPECT_TRUE(std::isnan(reading->scan.ranges_m[beam])) << beam;
        } else {
            EXPECT_EQ(reading->scan.ranges_m[beam], expected[beam]) << beam;
        }
    }
}

TEST(DecodeScan, TakesTheFirstOrTheStrongestEcho) {
    const std::vector<std::byte> cdr = encode_cdr(echoes_message());
    const std::vector<std::byte> ros1 = test::encode_ros1(echoes_message());
    McapChannel channel;
    channel.schema.name = "sensor_msgs/msg/MultiEchoLaserScan";
    channel.message_encoding = "cdr";
    EXPECT_EQ(kind_of(channel), MessageKind::scan);
    expect_ranges(decode_scan({.channel = &channel, .data = cdr}), {2.0F, 1.0F, LaserScan::invalid, 4.0F});
    expect_ranges(decode_scan({.channel = &channel, .data = cdr}, Echo::strongest),
                  {2.0F, 3.0F, LaserScan::invalid, 4.0F});
    channel.schema.name = "sensor_msgs/MultiEchoLaserScan";
    channel.message_encoding = "ros1";
    expect_ranges(decode_scan({.channel = &channel, .data = ros1}), {2.0F, 1.0F, LaserScan::invalid, 4.0F});
    EXPECT_FALSE(decode_scan({.channel = &channel, .data = std::span(ros1).first(ros1.size() - 1)}));
}

}  // namespace
}  // namespace ddtool
