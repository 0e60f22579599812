#include "ros/robot_messages.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "logs/messages/ros_codec.hpp"
#include "ros/latency_record.hpp"
#include "ros/robot_clock.hpp"
#include "ros/silence_watch.hpp"
#include "ros/stamp_bytes.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;

constexpr std::int64_t one_second = 1'000'000'000;

std::vector<std::byte> bytes_of(int number) { return {static_cast<std::byte>(number)}; }

/// "topic:number" of the messages that wait.
std::vector<std::string> rest_of(RobotMessages& messages, std::size_t count) {
    std::vector<std::string> rest;
    while (const auto message = messages.next([&] { return rest.size() == count; })) {
        rest.push_back(message->channel->topic + ":" + std::to_string(std::to_integer<int>(message->data[0])));
    }
    return rest;
}

TEST(RobotMessages, KeepTheNewestScanAndAllPoses) {
    RobotMessages messages([](const McapChannel&, RobotMessages::Arrived&) {});
    const std::size_t scan = messages.add_topic("/scan", "sensor_msgs/msg/LaserScan", RobotMessages::Kind::scan);
    const std::size_t rear = messages.add_topic("/rear", "sensor_msgs/msg/LaserScan", RobotMessages::Kind::scan);
    const std::size_t odom = messages.add_topic("/odom", "nav_msgs/msg/Odometry", RobotMessages::Kind::other);
    messages.push(scan, bytes_of(1), 0, 0);
    messages.push(odom, bytes_of(2), 0, 0);
    messages.push(rear, bytes_of(3), 0, 0);
    messages.push(scan, bytes_of(4), 0, 0);
    messages.push(odom, bytes_of(5), 0, 0);
    EXPECT_THAT(rest_of(messages, 4), ElementsAre("/odom:2", "/rear:3", "/scan:4", "/odom:5"));
    EXPECT_EQ(messages.passed_over(), 1U);
    EXPECT_EQ(messages.scans(), 3U);
}

TEST(RobotMessages, EndWhenTheyAreToldTo) {
    RobotMessages messages([](const McapChannel&, RobotMessages::Arrived&) {});
    EXPECT_FALSE(messages.next([] { return true; }));
}

TEST(RobotMessages, WaitForAMessageOfAnotherThread) {
    RobotMessages messages([](const McapChannel&, RobotMessages::Arrived& message) { message.data[0] = std::byte{9}; });
    const std::size_t odom = messages.add_topic("/odom", "nav_msgs/msg/Odometry", RobotMessages::Kind::other);
    std::jthread other([&] { messages.push(odom, bytes_of(1), 7, 8); });
    const auto message = messages.next([] { return false; });
    ASSERT_TRUE(message);
    EXPECT_EQ(message->log_time_ns, 8);
    EXPECT_EQ(message->data[0], std::byte{9});
}

TEST(StampBytes, AreThoseOfTheHeaderInBothByteOrders) {
    RosLaserScan scan;
    scan.header = {{5 * one_second + 7}, "laser"};
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        std::vector<std::byte> message = encode_cdr(scan, order);
        EXPECT_EQ(first_stamp_ns(message), 5 * one_second + 7);
        set_first_stamp(message, -3 * one_second + 1);
        EXPECT_EQ(decode_cdr<RosLaserScan>(message)->header.stamp.ns, -3 * one_second + 1);
        EXPECT_EQ(decode_cdr<RosLaserScan>(message)->header.frame_id, "laser");
    }
    EXPECT_EQ(first_stamp_ns(std::vector<std::byte>(11)), std::nullopt);
}

TEST(RobotClock, GoesOnBetweenStampsAndFollowsAClockThatIsSetBack) {
    RobotClock clock(false);
    EXPECT_EQ(clock.now_ns(0), 0);
    clock.heard(100 * one_second, 1 * one_second);
    EXPECT_EQ(clock.now_ns(3 * one_second), 102 * one_second);
    clock.heard(101 * one_second + one_second / 2, 3 * one_second);  // half a one_second late
    EXPECT_EQ(clock.now_ns(3 * one_second), 102 * one_second);
    clock.heard(50 * one_second, 4 * one_second);
    EXPECT_EQ(clock.now_ns(5 * one_second), 51 * one_second);
}

TEST(RobotClock, OfASimulatorStandsStill) {
    RobotClock clock(true);
    EXPECT_FALSE(clock.is_told());
    clock.heard(100 * one_second, 1 * one_second);
    clock.told(7 * one_second);
    EXPECT_TRUE(clock.is_told());
    EXPECT_EQ(clock.now_ns(50 * one_second), 7 * one_second);
}

TEST(SilenceWatch, TellsWhenATopicFallsSilentAndComesBack) {
    SilenceWatch watch;
    const std::size_t scan = watch.add_topic("/scan");
    const std::size_t slow = watch.add_topic("/slow");
    watch.add_topic("/never");
    for (int step = 0; step < 20; ++step) {
        watch.heard(scan, 100 * one_second + step * one_second / 10);
    }
    watch.heard(slow, 99 * one_second);
    watch.heard(slow, 102 * one_second);
    EXPECT_FALSE(watch.look(103 * one_second));
    const auto silent = watch.look(105 * one_second);
    ASSERT_TRUE(silent);
    EXPECT_EQ(silent->topic, "/scan");
    EXPECT_FALSE(silent->is_back);
    EXPECT_TRUE(watch.is_silent(scan));
    EXPECT_FALSE(watch.look(120 * one_second)) << "said once, and /slow usually comes every three seconds";
    watch.heard(scan, 121 * one_second);
    const auto back = watch.look(121 * one_second);
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->is_back);
    EXPECT_NEAR(back->silent_s, 19.1, 0.01);
    EXPECT_FALSE(watch.look(121 * one_second));
    EXPECT_EQ(watch.silences(), 1U);
    EXPECT_THAT(watch.never_heard(), ElementsAre("/never"));
}

TEST(LatencyRecord, HasQuantilesToOnePartInTen) {
    LatencyRecord record;
    EXPECT_EQ(record.quantile_s(0.5), 0.0);
    for (int milliseconds = 1; milliseconds <= 100; ++milliseconds) {
        record.add(1e-3 * milliseconds);
    }
    record.add(1e9);
    EXPECT_NEAR(record.quantile_s(0.5), 0.05, 0.005);
    EXPECT_NEAR(record.quantile_s(0.99), 0.1, 0.01);
    EXPECT_EQ(record.count(), 101U);
}

}  // namespace
}  // namespace ddtool
