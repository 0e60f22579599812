#include "run/result_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "small_run.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

Pose2 planar(const RosPose& pose) { return to_pose2(to_isometry(pose)); }

void expect_near(const Pose2& a, const Pose2& b) {
    EXPECT_NEAR(a.x_m, b.x_m, 1e-9);
    EXPECT_NEAR(a.y_m, b.y_m, 1e-9);
    EXPECT_NEAR(wrap_angle(a.theta_rad - b.theta_rad), 0.0, 1e-9);
}

/// A run that is recorded and read back.
class ResultLogTest : public testing::Test {
protected:
    ResultLogTest() {
        ResultLog log(file_);
        result_ = small_.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
            log.add(frame, update, small_.filter());
            if (update) {
                used_.push_back(frame);
                poses_.push_back(update->pose);
                swarms_.push_back(update->corrected.particles.size());
            }
            online_.push_back(small_.filter().pose());
            covariances_.push_back(small_.filter().pose_covariance());
            return true;
        });
        log.finish(map_raster(result_.map), result_.trajectory);
        log.close();
    }

    /// All messages of a topic, in the order of the file.
    template <typename Message>
    std::vector<Message> messages(const std::string& topic) {
        std::vector<Message> found;
        McapReader reader(file_, [](const LogProblem& problem) { ADD_FAILURE() << problem.what; });
        while (const auto message = reader.next()) {
            if (message->channel->topic == topic) {
                EXPECT_EQ(message->channel->schema.name, Message::type_name);
                const auto decoded = decode_cdr<Message>(message->data);
                EXPECT_TRUE(decoded.has_value());
                found.push_back(decoded.value_or(Message{}));
            }
        }
        return found;
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "result.mcap";
    test::SmallRun small_;
    FilterRun result_;
    std::vector<SensorFrame> used_;
    std::vector<Pose2> poses_;
    std::vector<Pose2> online_;  ///< one per scan
    std::vector<Eigen::Matrix3d> covariances_;
    std::vector<std::size_t> swarms_;
};

TEST_F(ResultLogTest, HoldsTheScansThatWereUsed) {
    const auto scans = messages<RosLaserScan>("/scan");
    ASSERT_EQ(scans.size(), result_.updates);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        EXPECT_EQ(scans[i].header.stamp.ns, used_[i].scan.stamp_ns);
        EXPECT_EQ(scans[i].ranges.size(), used_[i].scan.ranges_m.size());
    }
}

TEST_F(ResultLogTest, TellsTheDegreeOfEveryUpdate) {
    const auto degrees = messages<RosDegeneracy>("/degeneracy");
    ASSERT_EQ(degrees.size(), used_.size());
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        EXPECT_EQ(degrees[i].stamp.ns, used_[i].scan.stamp_ns);
        EXPECT_GE(degrees[i].major_variance, degrees[i].minor_variance);
    }
}

TEST_F(ResultLogTest, TellsPoseAndCovarianceOfEveryScan) {
    const auto poses = messages<RosPoseWithCovarianceStamped>("/pose");
    ASSERT_EQ(poses.size(), result_.trajectory.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_EQ(poses[i].header.stamp.ns, result_.trajectory[i].stamp_ns);
        expect_near(planar(poses[i].pose), online_[i]);
        EXPECT_EQ(poses[i].covariance[0], covariances_[i](0, 0));
        EXPECT_EQ(poses[i].covariance[5], covariances_[i](0, 2));
        EXPECT_EQ(poses[i].covariance[14], 0.0);
        EXPECT_EQ(poses[i].covariance[35], covariances_[i](2, 2));
    }
    EXPECT_GT(poses.back().covariance[0] * poses.back().covariance[7] * poses.back().covariance[35], 0.0);
}

TEST_F(ResultLogTest, TransformsLeadFromTheMapToTheLaser) {
    const auto transforms = messages<RosTFMessage>("/tf");
    ASSERT_EQ(transforms.size(), used_.size());
    for (std::size_t i = 0; i < used_.size(); ++i) {
        const RosTransformStamped& odom = transforms[i].transforms.at(0);
        const RosTransformStamped& robot = transforms[i].transforms.at(1);
        EXPECT_EQ(odom.header.frame_id + ">" + odom.child_frame_id, "map>odom");
        EXPECT_EQ(robot.header.frame_id + ">" + robot.child_frame_id, "odom>base_link");
        expect_near(planar(odom.transform) * planar(robot.transform), poses_[i]);
    }
    const auto mounting = messages<RosTFMessage>("/tf_static");
    ASSERT_EQ(mounting.size(), 1U);
    expect_near(planar(mounting[0].transforms.at(0).transform), used_[0].robot_from_laser);
    EXPECT_EQ(mounting[0].transforms.at(0).child_frame_id, messages<RosLaserScan>("/scan")[0].header.frame_id);
}

TEST_F(ResultLogTest, EndsWithTheMapAndThePath) {
    const auto maps = messages<RosOccupancyGrid>("/map");
    const MapRaster map = map_raster(result_.map);
    ASSERT_GE(maps.size(), 2U);
    EXPECT_EQ(maps.back().data, map.cells);
    EXPECT_EQ(maps.back().width, map.width);
    EXPECT_NEAR(maps.back().origin.position.y, map.origin_m.y_m, 1e-9);
    const auto paths = messages<RosPath>("/path");
    ASSERT_EQ(paths.size(), maps.size());
    expect_near(planar(paths.back().poses.front().pose), result_.trajectory.front().pose);
    expect_near(planar(paths.back().poses.back().pose), result_.trajectory.back().pose);
    EXPECT_LT(paths.back().poses.size(), result_.trajectory.size());
}

TEST_F(ResultLogTest, HoldsAPathThatStaysSmallOnALongDrive) {
    Trajectory drive;
    for (std::int64_t i = 0; i < 200'000; ++i) {
        drive.push_back({i, {static_cast<double>(i), 0.0, 0.0}});
    }
    ResultLog log(file_);
    log.finish(map_raster(result_.map), drive);
    log.close();
    const std::vector<RosPoseStamped> poses = messages<RosPath>("/path").at(0).poses;
    EXPECT_LE(poses.size(), 8194U);
    EXPECT_GT(poses.size(), 5000U);
    EXPECT_EQ(poses.back().header.stamp.ns, drive.back().stamp_ns);
}

TEST_F(ResultLogTest, HoldsTheParticles) {
    const auto clouds = messages<RosPoseArray>("/particlecloud");
    ASSERT_EQ(clouds.size(), swarms_.size());
    for (std::size_t i = 0; i < clouds.size(); ++i) {
        EXPECT_EQ(clouds[i].poses.size(), swarms_[i]);
        EXPECT_EQ(clouds[i].header.frame_id, "map");
    }
}

TEST_F(ResultLogTest, OffersLateListenersTheMapAndTheMounting) {
    McapReader reader(file_, {});
    while (const auto message = reader.next()) {
        const std::string& topic = message->channel->topic;
        const std::string durability = topic == "/map" || topic == "/tf_static" ? "durability: 1" : "durability: 2";
        EXPECT_THAT(message->channel->metadata.at("offered_qos_profiles"), testing::HasSubstr(durability)) << topic;
    }
}

TEST_F(ResultLogTest, IsALogItself) {
    const auto log = open_log(file_, {}, [](const LogProblem& problem) { ADD_FAILURE() << problem.what; });
    for (const SensorFrame& frame : used_) {
        const auto read = log->next();
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(read->scan.stamp_ns, frame.scan.stamp_ns);
        expect_near(read->odom_from_robot, frame.odom_from_robot);
        expect_near(read->robot_from_laser, frame.robot_from_laser);
    }
    EXPECT_FALSE(log->next().has_value());
}

TEST(ResultLog, HoldsFewMapsHoweverLongTheRun) {
    const test::TemporaryFolder folder;
    ThreadPool threads(1);
    Rbpf filter(test::SmallRun::settings(), threads);
    ResultLog log(folder / "long.mcap");
    SensorFrame frame;
    constexpr int days = 10;
    for (int minute = 0; minute < days * 24 * 60; ++minute) {
        frame.scan.stamp_ns = std::int64_t{60'000'000'000} * minute;
        frame.odom_from_robot.x_m = minute % 2;
        log.add(frame, filter.update(frame), filter);
    }
    log.close();
    std::map<std::string, int> counts;
    McapReader reader(folder / "long.mcap", [](const LogProblem& problem) { ADD_FAILURE() << problem.what; });
    while (const auto message = reader.next()) {
        ++counts[message->channel->topic];
    }
    EXPECT_EQ(counts["/scan"], days * 24 * 60);
    EXPECT_GT(counts["/map"], 10);
    EXPECT_LT(counts["/map"], 200);
}

}  // namespace
}  // namespace ddtool
