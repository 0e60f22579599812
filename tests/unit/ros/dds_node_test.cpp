#include "ros/dds_node.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "cyclone.hpp"
#include "logs/messages/ros_codec.hpp"
#include "ros/type_hash.hpp"

namespace ddtool {
namespace {

using namespace std::chrono_literals;
using test::CycloneParticipant;
using test::CycloneReader;
using test::CycloneWriter;
using test::holds_within;

/// Tests that run at the same time must not hear each other.
std::uint32_t domain_of_test() { return 100U + static_cast<std::uint32_t>(getpid()) % 100U; }

RosEnvironment loopback() {
    RosEnvironment environment;
    environment.domain = domain_of_test();
    environment.loopback_only = true;
    return environment;
}

constexpr const char* scan_type = RosLaserScan::type_name;
constexpr const char* map_type = RosOccupancyGrid::type_name;

/// What a reader has received, from any thread.
class Received {
public:
    DdsNode::Receive add() {
        return [this](std::span<const std::byte> bytes) {
            const std::lock_guard lock(mutex_);
            messages_.emplace_back(bytes.begin(), bytes.end());
        };
    }
    [[nodiscard]] std::size_t count() const {
        const std::lock_guard lock(mutex_);
        return messages_.size();
    }
    [[nodiscard]] std::vector<std::byte> at(std::size_t index) const {
        const std::lock_guard lock(mutex_);
        return messages_.at(index);
    }

private:
    mutable std::mutex mutex_;
    std::vector<std::vector<std::byte>> messages_;
};

struct CycloneScan {
    explicit CycloneScan(std::size_t beams, std::int32_t number) : ranges(beams, 2.5F) {
        message.header.stamp.sec = number;
        message.header.stamp.nanosec = 7;
        message.header.frame_id = frame.data();
        message.angle_min = -1.0F;
        message.angle_increment = 0.01F;
        message.range_max = 30.0F;
        message.ranges._length = static_cast<std::uint32_t>(ranges.size());
        message.ranges._maximum = message.ranges._length;
        message.ranges._buffer = ranges.data();
    }

    std::string frame = "laser";
    std::vector<float> ranges;
    sensor_msgs_msg_dds__LaserScan_ message{};
};

TEST(DdsNode, NamesTypesAsRos2DoesInDds) {
    EXPECT_EQ(dds_type_name("sensor_msgs/msg/LaserScan"), "sensor_msgs::msg::dds_::LaserScan_");
}

TEST(DdsNode, HearsTheOtherMakersScansInOrderAndWhole) {
    DdsNode node(loopback(), "listener", "/");
    Received received;
    node.subscribe("/scan", scan_type, {.reliable = false, .depth = 5}, received.add());
    const CycloneParticipant robot(domain_of_test());
    CycloneWriter<sensor_msgs_msg_dds__LaserScan_> writer(robot, sensor_msgs_msg_dds__LaserScan__desc, "rt/scan",
                                                          {.reliable = false, .depth = 5});
    ASSERT_TRUE(holds_within(10s, [&] { return writer.readers() == 1 && node.writers_of("/scan") == 1; }));
    constexpr std::size_t scans = 80;
    for (std::size_t number = 0; number < scans; ++number) {
        writer.write(CycloneScan(1000, static_cast<std::int32_t>(number)).message);
        std::this_thread::sleep_for(5ms);
    }
    ASSERT_TRUE(holds_within(5s, [&] { return received.count() >= scans; }));
    ASSERT_EQ(received.count(), scans);
    for (std::size_t number = 0; number < scans; ++number) {
        const auto scan = decode_cdr<RosLaserScan>(received.at(number));
        ASSERT_TRUE(scan);
        EXPECT_EQ(scan->header.stamp.ns, static_cast<std::int64_t>(number) * 1'000'000'000 + 7);
        EXPECT_EQ(scan->header.frame_id, "laser");
        EXPECT_EQ(scan->ranges, std::vector<float>(1000, 2.5F));
    }
}

TEST(DdsNode, GivesTheLatestMapToTheOtherMakersLateReader) {
    DdsNode node(loopback(), "mapper", "/");
    const TopicQos qos{.reliable = true, .is_kept_for_late = true, .depth = 1};
    RosOccupancyGrid map;
    map.width = 1000;
    map.height = 1200;
    map.data.assign(map.width * map.height, 100);  // far more than a datagram holds
    node.write("/map", map_type, qos, encode_cdr(map));
    map.resolution = 0.05F;
    node.write("/map", map_type, qos, encode_cdr(map));
    const CycloneParticipant viewer(domain_of_test());
    CycloneReader<nav_msgs_msg_dds__OccupancyGrid_> reader(viewer, nav_msgs_msg_dds__OccupancyGrid__desc, "rt/map",
                                                           {.reliable = true, .is_kept_for_late = true, .depth = 1});
    std::size_t maps = 0;
    EXPECT_TRUE(holds_within(10s, [&] {
        reader.take([&](const nav_msgs_msg_dds__OccupancyGrid_& message) {
            ++maps;
            EXPECT_EQ(message.resolution, 0.05F);
            EXPECT_EQ(message.data._length, 1'200'000U);
            EXPECT_EQ(message.data._buffer[1'199'999], 100);
        });
        return maps > 0;
    }));
    EXPECT_EQ(maps, 1U);
}

TEST(DdsNode, DoesNotHearItself) {
    DdsNode node(loopback(), "both", "/");
    Received received;
    node.subscribe("/tf", RosTFMessage::type_name, {}, received.add());
    DdsNode other(loopback(), "other", "/");
    const auto message_of = [](const std::string& frame) {
        RosTransformStamped transform;
        transform.child_frame_id = frame;
        return encode_cdr(RosTFMessage{{transform}});
    };
    for (int round = 0; round < 500 && received.count() == 0; ++round) {
        node.write("/tf", RosTFMessage::type_name, {}, message_of("own"));
        other.write("/tf", RosTFMessage::type_name, {}, message_of("other"));
        std::this_thread::sleep_for(20ms);
    }
    std::this_thread::sleep_for(100ms);
    ASSERT_GT(received.count(), 0U);
    for (std::size_t index = 0; index < received.count(); ++index) {
        EXPECT_EQ(received.at(index), message_of("other"));
    }
}

TEST(DdsNode, CountsNoWriterWhoseQualityOfServiceDoesNotSuffice) {
    DdsNode node(loopback(), "listener", "/");
    Received received;
    node.subscribe("/tf_static", RosTFMessage::type_name, {.reliable = true, .is_kept_for_late = true, .depth = 100},
                   received.add());
    testing::internal::CaptureStderr();  // both may find each other at once
    const CycloneParticipant robot(domain_of_test());
    CycloneWriter<tf2_msgs_msg_dds__TFMessage_> poor(robot, tf2_msgs_msg_dds__TFMessage__desc, "rt/tf_static",
                                                     {.reliable = true, .is_kept_for_late = false});
    std::this_thread::sleep_for(1500ms);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(node.writers_of("/tf_static"), 0U);
    EXPECT_THAT(said, testing::HasSubstr("/tf_static"));
    EXPECT_THAT(said, testing::HasSubstr("transient local"));
}

/// What the other maker's participant sees of a node.
struct Seen {
    std::string participant_data;
    std::string endpoint_data;
};

std::string user_data_of(const dds_qos_t* qos) {
    void* data = nullptr;
    std::size_t size = 0;
    dds_qget_userdata(qos, &data, &size);
    std::string text(static_cast<const char*>(data), size);
    dds_free(data);
    return text;
}

TEST(DdsNode, TellsItsEnclaveAndTheHashesOfItsTypes) {
    DdsNode node(loopback(), "mapper", "/");
    node.write("/map", map_type, {}, encode_cdr(RosOccupancyGrid{}));
    const CycloneParticipant viewer(domain_of_test());
    const dds_entity_t participants =
        dds_create_reader(viewer.handle(), DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr);
    const dds_entity_t writers =
        dds_create_reader(viewer.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
    Seen seen;
    const auto look = [&] {
        void* sample = nullptr;
        dds_sample_info_t info;
        while (dds_take(participants, &sample, &info, 1, 1) > 0) {
            const std::string data = user_data_of(static_cast<const dds_builtintopic_participant_t*>(sample)->qos);
            seen.participant_data = data.empty() ? seen.participant_data : data;
            dds_return_loan(participants, &sample, 1);
            sample = nullptr;
        }
        while (dds_take(writers, &sample, &info, 1, 1) > 0) {
            const auto* const endpoint = static_cast<const dds_builtintopic_endpoint_t*>(sample);
            if (std::string(endpoint->topic_name) == "rt/map") {
                seen.endpoint_data = user_data_of(endpoint->qos);
            }
            dds_return_loan(writers, &sample, 1);
            sample = nullptr;
        }
        return !seen.participant_data.empty() && !seen.endpoint_data.empty();
    };
    EXPECT_TRUE(holds_within(10s, look));
    EXPECT_EQ(seen.participant_data, "enclave=/;");
    EXPECT_EQ(seen.endpoint_data, "typehash=" + std::string(type_hash(map_type)) + ";");
}

TEST(DdsNode, TellsItsNameAndItsEndpoints) {
    DdsNode node(loopback(), "mapper", "/robot1");
    Received received;
    node.subscribe("/robot1/scan", scan_type, {}, received.add());
    node.write("/robot1/map", map_type, {}, encode_cdr(RosOccupancyGrid{}));
    const CycloneParticipant viewer(domain_of_test());
    CycloneReader<rmw_dds_common_msg_dds__ParticipantEntitiesInfo_> reader(
        viewer, rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc, "ros_discovery_info",
        {.reliable = true, .is_kept_for_late = true, .depth = 100});
    std::string name;
    EXPECT_TRUE(holds_within(10s, [&] {
        reader.take([&](const rmw_dds_common_msg_dds__ParticipantEntitiesInfo_& message) {
            ASSERT_EQ(message.node_entities_info_seq._length, 1U);
            const auto& entities = message.node_entities_info_seq._buffer[0];
            name = std::string(entities.node_namespace) + "/" + entities.node_name;
            ASSERT_EQ(entities.reader_gid_seq._length, 1U);
            ASSERT_EQ(entities.writer_gid_seq._length, 1U);
            const auto* const prefix = message.gid.data;
            EXPECT_TRUE(std::equal(prefix, prefix + 12, entities.reader_gid_seq._buffer[0].data));
            EXPECT_TRUE(std::equal(prefix, prefix + 12, entities.writer_gid_seq._buffer[0].data));
        });
        return !name.empty();
    }));
    EXPECT_EQ(name, "/robot1/mapper");
}

}  // namespace
}  // namespace ddtool
