#include "logs/stream/topic_readings.hpp"

#include <gmock/gmock.h>

#include "ddtool/base/error.hpp"
#include "recording.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;

void ignore_share(double /*share*/) {}

class TopicReadings : public testing::Test {
protected:
    test::TemporaryFolder folder_;
    test::Recording recording_ = test::example_recording();
    std::filesystem::path log_ = folder_ / "a.mcap";
};

TEST_F(TopicReadings, PosesAreThoseThatWereRecorded) {
    test::write_mcap(log_, recording_);
    const Trajectory poses = read_poses(log_, "/odom", {}, {}, ignore_share);
    ASSERT_EQ(poses.size(), 24U);
    EXPECT_EQ(poses[1].stamp_ns, 80'000'000);
    EXPECT_NEAR(poses[1].pose.x_m, 0.08, 1e-9);
    EXPECT_NEAR(poses[1].pose.theta_rad, 0.1, 1e-9);
}

TEST_F(TopicReadings, TransformsAreChosenByTheirFrames) {
    test::record(recording_, "/tf", 20'000'000, transform_message(20'000'000, "odom", "base", {1.0, 0.0, 0.0}));
    test::write_mcap(log_, recording_);
    const Trajectory poses = read_poses(log_, "/tf", {"odom", "base"}, {}, ignore_share);
    ASSERT_EQ(poses.size(), 1U);
    EXPECT_EQ(poses.front().stamp_ns, 20'000'000);
    EXPECT_EQ(read_poses(log_, "/tf", {}, {}, ignore_share).size(), 2U);
}

TEST_F(TopicReadings, InertialReadingsOfTheFirstTopicOrTheNamedOne) {
    for (const std::string topic : {"/imu", "/other"}) {
        RosImu imu;
        imu.header = {{30'000'000}, "imu"};
        imu.angular_velocity = {0.1, 0.2, topic == "/imu" ? 0.3 : 0.4};
        imu.linear_acceleration = {0.0, 0.0, 9.8};
        test::record(recording_, topic, 30'000'000, imu);
    }
    test::write_mcap(log_, recording_);
    const std::vector<ImuReading> first = read_imu(log_, "", {}, ignore_share);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first.front().angular_velocity_rad_per_s.z(), 0.3);
    EXPECT_EQ(first.front().acceleration_m_per_s2.z(), 9.8);
    EXPECT_EQ(read_imu(log_, "/other", {}, ignore_share).front().angular_velocity_rad_per_s.z(), 0.4);
}

TEST_F(TopicReadings, SayWhatTheLogLacks) {
    test::write_mcap(log_, recording_);
    const auto failure = [&](const std::string& topic) {
        return test::thrown_text<UsageError>([&] { read_poses(log_, topic, {}, {}, ignore_share); });
    };
    EXPECT_THAT(failure("/odometry"), HasSubstr("a.mcap: '/odometry' is no topic with such poses"));
    EXPECT_THAT(failure("/scan"), HasSubstr("'/scan'"));
    EXPECT_THAT(test::thrown_text<UsageError>([&] { read_imu(log_, "", {}, ignore_share); }),
                HasSubstr("a.mcap: has no topic with readings of an inertial sensor"));
    const std::filesystem::path carmen = folder_ / "a.clf";
    write_file(carmen, "FLASER 5 2 2.1 2.2 2.1 2 0 0 0 0 0 0 10.0 host 0\n");
    EXPECT_THAT(test::thrown_text<Error>([&] { read_poses(carmen, "ODOM", {}, {}, ignore_share); }),
                HasSubstr("CARMEN"));
}

}  // namespace
}  // namespace ddtool
