#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/random.hpp"
#include "foxglove.pb.h"
#include "logs/messages/foxglove_json.hpp"
#include "logs/messages/foxglove_protobuf.hpp"

namespace ddtool {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

std::vector<std::byte> protobuf_scan_bytes() {
    FoxgloveLaserScan scan;
    scan.mutable_timestamp()->set_seconds(3);
    scan.mutable_timestamp()->set_nanos(5);
    scan.set_frame_id("laser");
    scan.mutable_pose()->mutable_position()->set_x(0.5);
    scan.mutable_pose()->mutable_orientation()->set_w(1.0);
    scan.set_start_angle(-1.0);
    scan.set_end_angle(1.0);
    for (const double range : {1.0, 2.0, 3.0}) {
        scan.add_ranges(range);
    }
    return bytes_of(scan.SerializeAsString());
}

const std::string json_scan_text = R"({"timestamp": {"sec": 3, "nsec": 5}, "frame_id": "laser",
    "pose": {"position": {"x": 0.5, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}},
    "start_angle": -1, "end_angle": 1.0, "ranges": [1, 2.0, 3], "intensities": []})";

void expect_the_scan(const std::optional<ScanReading>& reading) {
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->frame_id, "laser");
    EXPECT_EQ(reading->scan.stamp_ns, 3'000'000'005);
    EXPECT_DOUBLE_EQ(reading->scan.angle_rad(0), -1.0);
    EXPECT_DOUBLE_EQ(reading->scan.angle_rad(2), 1.0);
    EXPECT_EQ(reading->scan.ranges_m, (std::vector<float>{1, 2, 3}));
    EXPECT_DOUBLE_EQ(reading->frame_from_scan.translation().x(), 0.5);
}

TEST(FoxgloveScan, IsTheSameInProtobufAndJson) {
    expect_the_scan(foxglove_protobuf_scan(protobuf_scan_bytes()));
    expect_the_scan(foxglove_json_scan(bytes_of(json_scan_text)));
}

TEST(FoxgloveScan, JsonNullIsNoReading) {
    const auto scan = foxglove_json_scan(bytes_of(
        R"({"timestamp": {"sec": 0, "nsec": 0}, "frame_id": "", "start_angle": 0, "end_angle": 1, "ranges": [null]})"));
    ASSERT_TRUE(scan);
    EXPECT_TRUE(std::isnan(scan->scan.ranges_m.at(0)));
}

TEST(FoxgloveScan, AStampThatNoNumberHoldsIsNone) {
    for (const std::string seconds : {"1e66", "-1e66", "9.3e9", "18446744073709551615"}) {
        const auto scan = foxglove_json_scan(
            bytes_of(R"({"timestamp": {"sec": )" + seconds +
                     R"(, "nsec": 5}, "frame_id": "", "start_angle": 0, "end_angle": 1,)" + R"( "ranges": []})"));
        ASSERT_TRUE(scan) << seconds;
        EXPECT_EQ(scan->scan.stamp_ns, 0) << seconds;
    }
}

TEST(FoxgloveTransforms, AreTheSameInProtobufAndJson) {
    FoxgloveFrameTransforms message;
    FoxgloveFrameTransform& transform = *message.add_transforms();
    transform.mutable_timestamp()->set_seconds(2);
    transform.set_parent_frame_id("odom");
    transform.set_child_frame_id("base");
    transform.mutable_translation()->set_y(4.0);
    transform.mutable_rotation()->set_z(1.0);
    const std::string one = R"({"timestamp": {"sec": 2, "nsec": 0}, "parent_frame_id": "odom",
        "child_frame_id": "base", "translation": {"x": 0, "y": 4, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 1, "w": 0}})";
    for (const auto& readings :
         {foxglove_protobuf_poses("foxglove.FrameTransforms", bytes_of(message.SerializeAsString())),
          foxglove_protobuf_poses("foxglove.FrameTransform", bytes_of(transform.SerializeAsString())),
          foxglove_json_poses("foxglove.FrameTransforms", bytes_of(R"({"transforms": [)" + one + "]}")),
          foxglove_json_poses("foxglove.FrameTransform", bytes_of(one))}) {
        ASSERT_TRUE(readings);
        ASSERT_EQ(readings->size(), 1U);
        const PoseReading& reading = readings->front();
        EXPECT_EQ(reading.frame_id, "odom");
        EXPECT_EQ(reading.child_frame_id, "base");
        EXPECT_EQ(reading.stamp_ns, 2'000'000'000);
        EXPECT_DOUBLE_EQ(reading.frame_from_child.translation().y(), 4.0);
        EXPECT_DOUBLE_EQ(reading.frame_from_child.linear()(0, 0), -1.0);
    }
}

TEST(FoxglovePose, IsTheSameInProtobufAndJson) {
    FoxglovePoseInFrame message;
    message.set_frame_id("world");
    message.mutable_pose()->mutable_position()->set_x(1.5);
    message.mutable_pose()->mutable_orientation()->set_w(1.0);
    for (const auto& readings :
         {foxglove_protobuf_poses("foxglove.PoseInFrame", bytes_of(message.SerializeAsString())),
          foxglove_json_poses("foxglove.PoseInFrame",
                              bytes_of(R"({"timestamp": {"sec": 0, "nsec": 0}, "frame_id": "world",
              "pose": {"position": {"x": 1.5, "y": 0, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}})"))}) {
        ASSERT_TRUE(readings);
        EXPECT_EQ(readings->front().frame_id, "world");
        EXPECT_DOUBLE_EQ(readings->front().frame_from_child.translation().x(), 1.5);
    }
}

TEST(FoxgloveScan, AnyBytesGiveAScanOrNone) {
    const std::vector<std::byte> wire_bytes = protobuf_scan_bytes();
    const std::vector<std::byte> text = bytes_of(json_scan_text);
    for (std::size_t length = 0; length < text.size(); ++length) {
        EXPECT_FALSE(foxglove_json_scan(std::span(text).first(length))) << length;
    }
    for (std::uint64_t round = 0; round < 2000; ++round) {
        RandomStream random{23, round};
        std::vector<std::byte> damaged = round % 2 == 0 ? wire_bytes : text;
        for (int flips = 0; flips < 3; ++flips) {
            damaged[random.index(damaged.size())] = static_cast<std::byte>(random());
        }
        const auto reading = round % 2 == 0 ? foxglove_protobuf_scan(damaged) : foxglove_json_scan(damaged);
        EXPECT_LE(reading.value_or(ScanReading{}).scan.ranges_m.size(), damaged.size());
    }
}

}  // namespace
}  // namespace ddtool
