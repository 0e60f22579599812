#include "logs/messages/message_decoder.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"

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

}  // namespace
}  // namespace ddtool
