#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bag_file.hpp"
#include "db3_file.hpp"
#include "ddtool/base/error.hpp"
#include "foxglove.pb.h"
#include "logs/messages/foxglove_json.hpp"
#include "logs/messages/foxglove_protobuf.hpp"
#include "logs/messages/ros_readings.hpp"
#include "logs/stream/cloud_scan.hpp"
#include "logs/stream/message_log_stream.hpp"
#include "message_log.hpp"
#include "point_clouds.hpp"
#include "read_log.hpp"
#include "recording.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using test::cloud_message;
using test::CloudLayout;
using test::CloudPoint;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const std::vector<CloudPoint> three_points{{1.0, 2.0, 3.0}, {-4.0, 5.0, 0.0}, {7.0, -8.0, 9.0}};

std::optional<CloudReading> decoded_cloud(const RosPointCloud2& message) {
    return decode_ros_cloud("cdr", encode_cdr(message));
}

void expect_three_points(const std::optional<CloudReading>& reading) {
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->fault, "");
    EXPECT_THAT(reading->points_m,
                ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(-4, 5, 0), Eigen::Vector3f(7, -8, 9)));
}

TEST(PointCloud, IsReadInEveryLayout) {
    for (const std::uint8_t datatype : std::initializer_list<std::uint8_t>{5, 7, 8}) {
        for (const std::uint32_t rows : {1U, 3U}) {
            for (const bool big_endian : {false, true}) {
                const CloudLayout layout{.datatype = datatype,
                                         .before = 3,
                                         .behind = 5,
                                         .row_gap = 7,
                                         .rows = rows,
                                         .big_endian = big_endian};
                SCOPED_TRACE(std::to_string(datatype) + " rows " + std::to_string(rows) + (big_endian ? " big" : ""));
                expect_three_points(decoded_cloud(cloud_message(1.5, "lidar", three_points, layout)));
            }
        }
    }
}

TEST(PointCloud, IsTheSameInBothVersionsOfRos) {
    const RosPointCloud2 message = cloud_message(1.5, "lidar", three_points);
    for (const auto& reading :
         {decode_ros_cloud("ros1", test::encode_ros1(message)), decode_ros_cloud("cdr", encode_cdr(message)),
          decode_ros_cloud("cdr", encode_cdr(message, std::endian::big))}) {
        expect_three_points(reading);
        EXPECT_EQ(reading->frame_id, "lidar");
        EXPECT_EQ(reading->stamp_ns, 1'500'000'000);
    }
}

TEST(PointCloud, IsTheSameInFoxglovesMessages) {
    const RosPointCloud2 ros = cloud_message(1.5, "lidar", three_points);
    FoxglovePointCloud message;
    message.mutable_timestamp()->set_seconds(1);
    message.set_frame_id("lidar");
    message.mutable_pose()->mutable_position()->set_z(0.5);
    message.mutable_pose()->mutable_orientation()->set_w(1.0);
    message.set_point_stride(ros.point_step);
    for (const RosPointField& field : ros.point_fields) {
        FoxglovePackedElementField& packed = *message.add_fields();
        packed.set_name(field.name);
        packed.set_offset(field.offset);
        packed.set_type(field.datatype);  // the number of float32 is the same
    }
    message.set_data(std::string(ros.data.begin(), ros.data.end()));
    const std::string bytes = message.SerializeAsString();
    const auto from_protobuf = foxglove_protobuf_cloud(std::as_bytes(std::span(bytes)));
    expect_three_points(from_protobuf);
    EXPECT_DOUBLE_EQ(from_protobuf->frame_from_cloud.translation().z(), 0.5);

    // Two points of three float32, (1, 2, 3) and (0, 0, -1), in base64.
    const std::string json = R"({"timestamp": {"sec": 1, "nsec": 0}, "frame_id": "lidar", "point_stride": 12,
        "fields": [{"name": "x", "offset": 0, "type": 7}, {"name": "y", "offset": 4, "type": 7},
                   {"name": "z", "offset": 8, "type": 7}],
        "data": "AACAPwAAAEAAAEBAAAAAAAAAAAAAAIC/"})";
    const auto from_json = foxglove_json_cloud(std::as_bytes(std::span(json)));
    ASSERT_TRUE(from_json);
    EXPECT_THAT(from_json->points_m, ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(0, 0, -1)));
    EXPECT_FALSE(foxglove_json_cloud(std::as_bytes(std::span(json).first(40))));
}

TEST(PointCloud, LeavesOutPointsThatAreNoNumbers) {
    std::vector<CloudPoint> points = three_points;
    points.insert(points.begin() + 1, {not_a_number, not_a_number, not_a_number});
    points.push_back({1.0, 1.0, INFINITY});
    points.push_back({1.0, not_a_number, 1.0});
    expect_three_points(decoded_cloud(cloud_message(1.0, "lidar", points, {.rows = 2})));
}

TEST(PointCloud, SaysWhatIsWrongWithIt) {
    const RosPointCloud2 good = cloud_message(1.0, "lidar", three_points, {.rows = 3});
    const auto fault_of = [](const RosPointCloud2& message) {
        const auto reading = decoded_cloud(message);
        EXPECT_TRUE(reading && reading->points_m.empty());
        return reading->fault;
    };
    RosPointCloud2 message = good;
    message.point_fields[3].name = "depth";
    EXPECT_THAT(fault_of(message), HasSubstr("without the field z (its fields: intensity, x, y, depth)"));
    message = good;
    message.point_fields[1].datatype = 9;
    EXPECT_THAT(fault_of(message), HasSubstr("field x is no number"));
    message = good;
    message.point_fields[2].offset = 0xFFFFFFFF;
    EXPECT_THAT(fault_of(message), HasSubstr("field y is no number"));
    message = good;
    message.data.pop_back();
    EXPECT_THAT(fault_of(message), HasSubstr("expected 3 rows"));
    message = good;
    message.height = message.width = 0xFFFFFFFF;
    EXPECT_THAT(fault_of(message), HasSubstr("expected 4294967295 rows"));
    message = good;
    message.row_step = 1;
    EXPECT_THAT(fault_of(message), HasSubstr("1 bytes apart"));
    message = good;
    message.row_step = 0;  // left out by some writers
    EXPECT_TRUE(decoded_cloud(message)->fault.empty());
    std::vector<std::byte> cut = encode_cdr(good);
    cut.resize(cut.size() - 9);
    EXPECT_FALSE(decode_ros_cloud("cdr", cut));
}

CloudReading cloud_of(const std::vector<CloudPoint>& points) {
    CloudReading cloud;
    for (const CloudPoint& point : points) {
        cloud.points_m.emplace_back(static_cast<float>(point.x), static_cast<float>(point.y),
                                    static_cast<float>(point.z));
    }
    return cloud;
}

/// The range of the beam in that direction.
float range_towards(const LaserScan& scan, double angle_rad) {
    const auto beam = std::lround((angle_rad - scan.angle_min_rad) / scan.angle_increment_rad);
    return scan.ranges_m.at(static_cast<std::size_t>(beam));
}

TEST(CloudScan, TakesTheNearestPointOfTheBandInEachDirection) {
    const LaserScan scan = cloud_scan(cloud_of({{3.0, 0.0, 0.2},
                                                {2.0, 0.0, 0.0},
                                                {1.0, 0.0, -0.5},  // below the band
                                                {1.5, 0.0, 0.9},   // above it
                                                {0.0, 0.0, 0.0},   // the lidar itself
                                                {0.0, -4.0, 0.1}}),
                                      Eigen::Isometry3d::Identity(), {-0.3, 0.3}, 361);
    ASSERT_EQ(scan.ranges_m.size(), 361U);
    EXPECT_FLOAT_EQ(range_towards(scan, 0.0), 2.0F);
    EXPECT_FLOAT_EQ(range_towards(scan, -std::numbers::pi / 2), 4.0F);
    EXPECT_EQ(std::ranges::count_if(scan.ranges_m, [](float range) { return std::isfinite(range); }), 2);
    // Nothing is known of the other beams; they are not free up to the maximum range.
    EXPECT_TRUE(std::isnan(range_towards(scan, 1.0)));
}

TEST(CloudScan, MeasuresHeightsInTheRobotsFrame) {
    // A lidar 1 m above the floor that looks down by 30 degrees. The wall is 2 m ahead of it, the floor nearer.
    const Eigen::Isometry3d robot_from_cloud =
        Eigen::Translation3d(0.5, 0.25, 1.0) * Eigen::AngleAxisd(std::numbers::pi / 6, Eigen::Vector3d::UnitY());
    CloudReading cloud;
    for (const Eigen::Vector3d& in_robot : {Eigen::Vector3d(2.5, 0.25, 0.8), Eigen::Vector3d(1.5, 0.25, 0.02)}) {
        cloud.points_m.push_back((robot_from_cloud.inverse() * in_robot).cast<float>());
    }
    const LaserScan scan = cloud_scan(cloud, robot_from_cloud, {0.7, 1.3}, 361);
    EXPECT_NEAR(range_towards(scan, 0.0), 2.0, 1e-5);
    EXPECT_NEAR(range_towards(cloud_scan(cloud, robot_from_cloud, {0.0, 0.1}, 361), 0.0), 1.0, 1e-5);
}

TEST(CloudScan, HasAsManyBeamsAsTheCloudFills) {
    const auto beams = [](int columns) {
        return cloud_scan(cloud_of(test::round_room(5.0, -0.5, 16, columns)), Eigen::Isometry3d::Identity(),
                          band_around_unknown, 0)
            .ranges_m;
    };
    for (const auto& [columns, expected] : {std::pair{4000, 2880U}, {1800, 1440U}, {1024, 720U}, {400, 360U}}) {
        const std::vector<float> ranges = beams(columns);
        EXPECT_EQ(ranges.size(), expected) << columns;
        EXPECT_TRUE(std::ranges::all_of(ranges, [](float range) { return std::abs(range - 5.0F) < 1e-4F; })) << columns;
    }
    EXPECT_THAT(cloud_scan(cloud_of({}), Eigen::Isometry3d::Identity(), band_around_unknown, 0).ranges_m,
                testing::Each(testing::IsNan()));
}

TEST(CloudScan, LeavesOutTheFloorUnderAnyLidar) {
    EXPECT_DOUBLE_EQ(band_around_lidar(1.8).min_m, 1.5);
    EXPECT_DOUBLE_EQ(band_around_lidar(1.8).max_m, 2.1);
    for (const double low_m : {0.0, 0.15}) {
        EXPECT_DOUBLE_EQ(band_around_lidar(low_m).min_m, 0.1);
        EXPECT_DOUBLE_EQ(band_around_lidar(low_m).max_m, 0.7);
    }
}

class CloudLog : public testing::Test {
protected:
    void cloud(const std::string& topic, double stamp_s, const std::vector<CloudPoint>& points) {
        log_.add(topic, std::llround(stamp_s * 1e9), cloud_message(stamp_s, "lidar", points));
    }
    void mounting(double z_m) {
        RosTFMessage message = transform_message(0, "base", "lidar", {0.3, 0.0, 1.0});
        message.transforms.front().transform.position.z = z_m;
        log_.add("/tf_static", 0, message);
        log_.add("/odom", 0, odometry_message(0, "odom", "base", {}));
    }
    void scan(const std::string& topic) {
        RosLaserScan message;
        message.header = {{1'000'000'000}, "laser"};
        message.angle_increment = 0.1F;
        message.range_max = 10.0F;
        message.ranges = {1.0F, 2.0F};
        log_.add(topic, 1'000'000'000, message);
    }
    std::vector<SensorFrame> read(const LogOptions& options = {},
                                  MessageLogStream::Opening opening = MessageLogStream::Opening::twice) {
        problems_.clear();
        stream_ = std::make_unique<MessageLogStream>(
            [this](const LogProblemHandler&) { return log_.open(); }, opening, "test", "log", options,
            [this](const LogProblem& problem) { problems_.push_back(problem.what); });
        std::vector<SensorFrame> frames;
        while (auto frame = stream_->next()) {
            frames.push_back(std::move(*frame));
        }
        return frames;
    }
    std::string assumptions() const { return testing::PrintToString(stream_->summary().assumptions); }

    test::MessageLog log_;
    std::unique_ptr<MessageLogStream> stream_;
    std::vector<std::string> problems_;
};

TEST_F(CloudLog, BecomesScansWhereThereAreNone) {
    mounting(0.5);
    cloud("/points", 0.0, test::round_room(4.0, -0.5, 16, 900));
    for (const auto opening : {MessageLogStream::Opening::twice, MessageLogStream::Opening::once}) {
        const auto frames = read({}, opening);
        ASSERT_EQ(frames.size(), 1U);
        EXPECT_EQ(stream_->summary().scan_topic, "/points");
        EXPECT_EQ(frames[0].robot_from_laser, (Pose2{0.3, 0.0, 0.0}));
        EXPECT_EQ(frames[0].scan.ranges_m.size(), 720U);
        EXPECT_NEAR(range_towards(frames[0].scan, 0.5), 4.0, 1e-4);
        EXPECT_THAT(assumptions(), HasSubstr("between 0.20 and 0.80 m above the robot's origin"));
        EXPECT_THAT(problems_, IsEmpty());
    }
}

TEST_F(CloudLog, TakesTheBandThatIsAskedFor) {
    mounting(0.5);
    cloud("/points", 0.0, {{5.0, 0.0, -0.1}, {3.0, 0.0, 1.2}});
    LogOptions options;
    options.height = {1.5, 2.0};
    options.cloud_beams = 361;
    const SensorFrame frame = read(options).at(0);
    ASSERT_EQ(frame.scan.ranges_m.size(), 361U);
    EXPECT_NEAR(range_towards(frame.scan, 1.0), 3.0, 1e-4);  // the lidar is turned by 1 rad
}

TEST_F(CloudLog, TakesTheBandAroundALidarThatIsAnywhere) {
    cloud("/points", 0.0, test::round_room(4.0, -0.5, 16, 900));
    EXPECT_NEAR(range_towards(read().at(0).scan, 0.5), 4.0, 1e-4);
    EXPECT_THAT(assumptions(), HasSubstr("above the lidar, whose height on the robot is unknown"));
    log_.add("/tf", 0, transform_message(0, "odom", "base", {}));  // says nothing of the lidar
    log_.add("/tf_static", 0, transform_message(0, "lidar", "ring", {}));
    EXPECT_NEAR(range_towards(read().at(0).scan, 0.5), 4.0, 1e-4);
    EXPECT_THAT(assumptions(), HasSubstr("above the lidar, whose height on the robot is unknown"));
}

TEST_F(CloudLog, IsUsedBesideScansOnlyIfItIsNamed) {
    cloud("/points", 1.0, test::round_room(4.0, -0.5, 16, 900));
    scan("/scan");
    for (const auto opening : {MessageLogStream::Opening::twice, MessageLogStream::Opening::once}) {
        EXPECT_EQ(read({}, opening).at(0).scan.ranges_m.size(), 2U);
        LogOptions options;
        options.cloud_topic = "/points";
        EXPECT_EQ(read(options, opening).at(0).scan.ranges_m.size(), 720U);
    }
    LogOptions unknown;
    unknown.cloud_topic = "/scan";
    EXPECT_THROW(read(unknown), UsageError);
}

TEST_F(CloudLog, SaysWhichOfSeveralIsTaken) {
    for (const char* topic : {"/depth/points", "/points"}) {
        cloud(topic, 1.0, test::round_room(4.0, -0.5, 16, 900));
    }
    EXPECT_EQ(read().size(), 1U);
    EXPECT_THAT(assumptions(), HasSubstr("several point cloud topics (/depth/points, /points); using /points"));
}

TEST_F(CloudLog, CountsCloudsThatCannotBeRead) {
    cloud("/points", 0.1, test::round_room(4.0, -0.5, 16, 900));
    RosPointCloud2 damaged = cloud_message(0.2, "lidar", {{1.0, 0.0, 0.0}});
    damaged.data.clear();
    log_.add("/points", 200'000'000, damaged);
    cloud("/points", 0.3, {});
    log_.add_bytes("/points", "cdr", RosPointCloud2::type_name, 400'000'000, std::vector<std::byte>(7));
    EXPECT_EQ(read().size(), 1U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("a cloud of 0 bytes"), HasSubstr("a cloud without points"),
                                       HasSubstr("a damaged message")));
}

TEST_F(CloudLog, SaysThatTheBandIsEmpty) {
    cloud("/points", 0.1, {{3.0, 0.0, 2.0}});
    EXPECT_EQ(read().size(), 1U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("none of the 1 clouds has a point between")));
}

TEST(CloudContainers, HoldTheSameScans) {
    const test::TemporaryFolder folder;
    test::Recording recording;
    for (int i = 0; i < 3; ++i) {
        test::record(recording, "/points", i * 100'000'000,
                     cloud_message(1.0 + 0.1 * i, "lidar", test::round_room(4.0 + i, -0.5, 8, 900)));
    }
    test::write_mcap(folder / "log.mcap", recording);
    test::write_db3(folder / "log.db3", recording, Compression::none);
    write_file(folder / "log.bag", test::BagFile(recording, {}).bytes());
    const test::ReadLog expected = test::read_all(folder / "log.mcap");
    ASSERT_EQ(expected.frames.size(), 3U);
    for (const char* name : {"log.db3", "log.bag"}) {
        const test::ReadLog read = test::read_all(folder / name);
        EXPECT_EQ(read.error, "") << name;
        EXPECT_EQ(read.frames.size(), 3U) << name;
        EXPECT_TRUE(test::begins_with(read.frames, expected.frames)) << name;
    }
}

}  // namespace
}  // namespace ddtool
