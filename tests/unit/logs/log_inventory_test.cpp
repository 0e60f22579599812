#include "logs/stream/log_inventory.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "bag_file.hpp"
#include "ddtool/base/error.hpp"
#include "logs/stream/log_use.hpp"
#include "rosbag2_folder_files.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;

void no_progress(double /*share*/) {}

LogInventory inventory_of(const std::filesystem::path& path) {
    return take_inventory(
        path, [](const LogProblem& problem) { ADD_FAILURE() << problem.what; }, no_progress);
}

LogUse use_of_file(const std::filesystem::path& path) { return use_of(*open_log(path, {}, {}), no_progress); }

class Inventory : public testing::Test {
protected:
    test::TemporaryFolder folder_;
    const test::Recording recording_ = test::example_recording();
};

/// Every message must be counted under its topic, in every container.
TEST_F(Inventory, CountsWhatWasRecorded) {
    test::write_mcap(folder_ / "a.mcap", recording_);
    test::write_db3_folder(folder_ / "folder", recording_, 4);
    write_file(folder_ / "a.bag", test::BagFile(recording_, {}).bytes());
    for (const std::string name : {"a.mcap", "folder", "a.bag"}) {
        const LogInventory inventory = inventory_of(folder_ / name);
        ASSERT_EQ(inventory.topics.size(), 3U) << name;
        for (const TopicInventory& topic : inventory.topics) {
            EXPECT_EQ(topic.messages, static_cast<std::size_t>(
                                          std::ranges::count(recording_, topic.topic, &test::RecordedMessage::topic)));
        }
        EXPECT_EQ(inventory.messages(), recording_.size());
        EXPECT_NEAR(inventory.duration_s(),
                    1e-9 * static_cast<double>(recording_.back().stamp_ns - recording_.front().stamp_ns), 1e-9);
        EXPECT_NEAR(inventory.topics[0].rate_hz(), 25.0, 1e-6) << inventory.topics[0].topic;
        EXPECT_THAT(inventory.topics[0].frames, ElementsAre("odom -> base"));
        EXPECT_THAT(inventory.topics[1].frames, ElementsAre("laser"));
        EXPECT_TRUE(std::isnan(inventory.topics[2].rate_hz())) << "one transform has no rate";
    }
}

TEST_F(Inventory, TopicsThatAreOfNoUseAreCountedToo) {
    test::Recording recording = recording_;
    recording.push_back({"/image", "sensor_msgs/msg/Image", 5, {}, {std::byte{1}}});
    test::write_mcap(folder_ / "log", recording);
    const LogInventory inventory = inventory_of(folder_ / "log");
    EXPECT_EQ(inventory.topics[0].type, "sensor_msgs/msg/Image");
    EXPECT_EQ(inventory.topics[0].messages, 1U);
    EXPECT_THAT(inventory.topics[0].frames, testing::IsEmpty());
}

TEST_F(Inventory, CarmenLogsAreCountedByKindOfLine) {
    write_file(folder_ / "log",
               "# a comment\nPARAM robot_frontlaser_offset 0.1 0 host 0\nODOM 0 0 0 0 0 0 10.0 host 0\n"
               "FLASER 2 1.5 2.5 0 0 0 0 0 0 10.5 host 0\nFLASER 2 1.5 2.5 1 0 0 1 0 0 12.5 host 0\n");
    const LogInventory inventory = inventory_of(folder_ / "log");
    EXPECT_EQ(inventory.format, "CARMEN");
    ASSERT_EQ(inventory.topics.size(), 3U);
    EXPECT_EQ(inventory.topics[0].topic, "FLASER");
    EXPECT_EQ(inventory.topics[0].messages, 2U);
    EXPECT_EQ(inventory.topics[0].rate_hz(), 0.5);
    EXPECT_EQ(inventory.duration_s(), 2.5) << "the parameter's time of 0 says nothing";
}

std::string error_of(const std::filesystem::path& path) {
    try {
        open_log(path, {}, {});
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

/// A recording of three scans, changed in some way.
test::Recording three_scans(const std::function<void(RosLaserScan&)>& change) {
    test::Recording recording;
    for (std::int64_t stamp_ns = 100'000'000; stamp_ns < 400'000'000; stamp_ns += 100'000'000) {
        RosLaserScan scan;
        scan.header = {{stamp_ns}, "laser"};
        scan.angle_min = -1.0F;
        scan.angle_increment = 0.5F;
        scan.range_max = 10.0F;
        scan.ranges = {1.0F, 2.0F, 3.0F, 4.0F};
        change(scan);
        test::record(recording, "/scan", stamp_ns, scan);
    }
    return recording;
}

TEST_F(Inventory, ScansThatHoldNothingAreRefusedInOneLine) {
    const std::string nothing = "none of the 3 scans of /scan has a range";
    test::write_mcap(folder_ / "empty", three_scans([](RosLaserScan& scan) { scan.ranges.clear(); }));
    EXPECT_THAT(error_of(folder_ / "empty"), testing::HasSubstr(nothing));
    test::write_mcap(folder_ / "nan", three_scans([](RosLaserScan& scan) { scan.ranges.assign(4, NAN); }));
    EXPECT_THAT(error_of(folder_ / "nan"), testing::HasSubstr(nothing));
    test::write_mcap(folder_ / "inf", three_scans([](RosLaserScan& scan) { scan.ranges.assign(4, INFINITY); }));
    EXPECT_THAT(error_of(folder_ / "inf"), testing::HasSubstr(nothing));
    test::Recording other = three_scans([](RosLaserScan&) {});
    for (test::RecordedMessage& message : other) {
        message.cdr[1] = std::byte{0x0A};
    }
    test::write_mcap(folder_ / "other", other);
    EXPECT_THAT(
        error_of(folder_ / "other"),
        testing::AllOf(testing::HasSubstr("none of the 3 scans of /scan can be read"), testing::HasSubstr("PL_CDR2")));
    write_file(folder_ / "carmen", "FLASER 2 81.83 81.83 0 0 0 0 0 0 10.5 host 0\n");
    EXPECT_THAT(error_of(folder_ / "carmen"), testing::HasSubstr("none of the first 1 scans FLASER has a range"));
}

TEST_F(Inventory, AScanTopicWithRangesIsPreferredToAnEmptyOne) {
    test::Recording recording = three_scans([](RosLaserScan&) {});
    for (test::RecordedMessage& message : recording) {
        message.topic = "/scan_front";
    }
    for (test::RecordedMessage& message : three_scans([](RosLaserScan& scan) { scan.ranges.clear(); })) {
        recording.push_back(std::move(message));
    }
    test::write_mcap(folder_ / "log", recording);
    EXPECT_EQ(use_of_file(folder_ / "log").summary.scan_topic, "/scan_front");
}

TEST_F(Inventory, UseIsWhatTheFramesAre) {
    test::write_mcap(folder_ / "log", recording_);
    const LogUse use = use_of_file(folder_ / "log");
    EXPECT_EQ(use.summary.scans, 9U);
    EXPECT_EQ(use.fewest_beams, 4U);
    EXPECT_EQ(use.most_beams, 4U);
    EXPECT_NEAR(use.field_of_view_rad, 1.5, 1e-9);
    EXPECT_EQ(use.beams, 36U);
    EXPECT_EQ(use.returns, 27U) << "one beam of each scan has none";
    EXPECT_NEAR(use.longest_gap_s, 0.1, 1e-9);
    EXPECT_EQ(use.stamps_back, 0U);
    EXPECT_NEAR(use.odometry_m, 0.8, 0.05);
    EXPECT_EQ(use.robot_from_lasers.at(0).x_m, 0.2);
    EXPECT_EQ(use.with_ground_truth, 0U);
}

}  // namespace
}  // namespace ddtool
