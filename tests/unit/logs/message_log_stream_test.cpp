#include "logs/stream/message_log_stream.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "ddtool/base/error.hpp"
#include "log_topics.hpp"
#include "message_log.hpp"
#include "room_scan.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t second = 1'000'000'000;

RosLaserScan scan_message(double stamp_s, const std::string& frame_id = "laser") {
    RosLaserScan scan;
    scan.header = {{std::llround(stamp_s * 1e9)}, frame_id};
    scan.angle_min = -1.0F;
    scan.angle_increment = 0.5F;
    scan.range_min = 0.1F;
    scan.range_max = 10.0F;
    scan.ranges = {1.0F, 2.0F, 3.0F, 4.0F};
    return scan;
}

std::int64_t at(double stamp_s) { return std::llround(stamp_s * 1e9); }

class Log : public testing::Test {
protected:
    void scan(double stamp_s, double recorded_s) { log_.add("/scan", at(recorded_s), scan_message(stamp_s)); }
    void scan(double stamp_s) { scan(stamp_s, stamp_s); }
    void odometry(double stamp_s, double x, const std::string& topic = "/odom") {
        log_.add(topic, at(stamp_s), odometry_message(at(stamp_s), "odom", "base", {x, 0.0, 0.0}));
    }
    void transform(const std::string& parent, const std::string& child, const Pose2& pose, double stamp_s = 0.0,
                   const std::string& topic = "/tf_static") {
        log_.add(topic, at(stamp_s), transform_message(at(stamp_s), parent, child, pose));
    }
    /// The scans of a robot that drives along x at 1 m/s, with odometry.
    void drive(const std::string& scans, const std::string& odometry_topic, double speed) {
        for (int i = 1; i < 20; ++i) {
            scan_in("laser", i, scans);
            odometry(i, speed * i, odometry_topic);
        }
    }
    void scan_in(const std::string& frame, double stamp_s, const std::string& topic = "/scan") {
        log_.add(topic, at(stamp_s), scan_message(stamp_s, frame));
    }
    void transform(const std::string& parent, const std::string& child, const RosPose& pose) {
        RosTFMessage message = transform_message(0, parent, child, {});
        message.transforms.front().transform = pose;
        log_.add("/tf_static", 0, message);
    }
    std::unique_ptr<MessageLogStream> open(const LogOptions& options = {}) {
        return std::make_unique<MessageLogStream>(
            [this](const LogProblemHandler&) { return log_.open(); }, MessageLogStream::Opening::twice, "test", "log",
            options, [this](const LogProblem& problem) { problems_.push_back(problem.what); });
    }
    std::unique_ptr<MessageLogStream> open_live() {
        return std::make_unique<MessageLogStream>(
            [this](const LogProblemHandler&) { return log_.open(); }, MessageLogStream::Opening::live, "test", "robot",
            LogOptions{}, [this](const LogProblem& problem) { problems_.push_back(problem.what); });
    }
    std::vector<SensorFrame> read(const LogOptions& options = {}) {
        stream_ = open(options);
        std::vector<SensorFrame> frames;
        while (auto frame = stream_->next()) {
            frames.push_back(std::move(*frame));
        }
        return frames;
    }
    std::string failure(const LogOptions& options = {}) {
        try {
            open(options);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    test::MessageLog log_;
    std::unique_ptr<MessageLogStream> stream_;
    std::vector<std::string> problems_;
};

TEST_F(Log, InterpolatesOdometryThatComesBehindTheScan) {
    odometry(1.0, 1.0);
    scan(1.25);
    scan(1.5);
    odometry(2.0, 2.0);
    const auto frames = read();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_NEAR(frames[0].odom_from_robot.x_m, 1.25, 1e-9);
    EXPECT_NEAR(frames[1].odom_from_robot.x_m, 1.5, 1e-9);
    EXPECT_TRUE(problems_.empty());
}

TEST_F(Log, TakesTheNearestOdometryAtItsEndsAndReportsGaps) {
    scan(0.8);
    odometry(1.0, 1.0);
    odometry(2.0, 2.0);
    scan(2.2);
    scan(9.0);
    const auto frames = read();
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[0].odom_from_robot.x_m, 1.0);
    EXPECT_EQ(frames[1].odom_from_robot.x_m, 2.0);
    EXPECT_EQ(frames[2].odom_from_robot.x_m, 2.0);
    EXPECT_EQ(stream_->summary().problems, 1U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("no odometry within")));
}

/// Odometry at 20 Hz of a robot that drives along x at 0.5 m/s, missing for some time, and scans at 5 Hz.
TEST_F(Log, OdometryThatIsMissingForAPartIsAGuessThereAndSaid) {
    transform("base", "laser", Pose2{});
    for (int i = 0; i < 400; ++i) {
        const double t = 0.05 * i;
        if (t < 5.0 || t > 9.0) {
            odometry(t + 1.0, 0.5 * t);
        }
        if (i % 4 == 2) {
            scan(t + 1.0);
        }
    }
    const auto frames = read();
    std::vector<double> guessed_s;
    for (const SensorFrame& frame : frames) {
        if (frame.odom_step != OdometryStep::measured) {
            EXPECT_EQ(frame.odom_step, OdometryStep::guessed);
            guessed_s.push_back(1e-9 * static_cast<double>(frame.scan.stamp_ns) - 1.0);
        }
    }
    ASSERT_FALSE(guessed_s.empty());
    EXPECT_NEAR(guessed_s.front(), 5.1, 1e-6);
    EXPECT_NEAR(guessed_s.back(), 9.1, 1e-6);
    EXPECT_NEAR(frames.at(35).odom_from_robot.x_m, 3.55, 1e-6);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("the odometry /odom is missing for 4.1 s")));
}

TEST_F(Log, VelocitiesAndEstimatesAreOdometryWhereThereIsNoOther) {
    for (int i = 0; i < 100; ++i) {
        const double t = 0.1 * i + 1.0;
        RosTwistStamped twist{{{at(t)}, "base"}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.5}};
        log_.add("/wheels", at(t), twist);
        log_.add("/cmd_vel", at(t), RosTwistStamped{{{at(t)}, "base"}, {9.0, 0.0, 0.0}, {}});
        scan(t);
    }
    const auto frames = read();
    EXPECT_EQ(stream_->summary().odom_topic, "/wheels");
    EXPECT_NEAR(frames.at(80).odom_from_robot.theta_rad, wrap_angle(4.0), 1e-6);
    EXPECT_NEAR(frames.at(80).odom_from_robot.x_m, 2.0 * std::sin(4.0), 0.01) << "a circle of radius 2 m";
    EXPECT_NEAR(frames.at(80).odom_from_robot.y_m, 2.0 - 2.0 * std::cos(4.0), 0.01);
    for (int i = 0; i < 100; ++i) {
        RosPoseWithCovarianceStamped pose{{{at(0.1 * i + 1.0)}, "odom"}, {{0.3 * i, 0.0, 0.0}, {}}, {}};
        log_.add("/robot_pose_ekf/estimate", at(0.1 * i + 1.0), pose);
    }
    EXPECT_NEAR(read().at(80).odom_from_robot.x_m, 24.0, 1e-6);
    EXPECT_EQ(stream_->summary().odom_topic, "/robot_pose_ekf/estimate");
    EXPECT_NEAR(read(test::topics("", "/cmd_vel")).at(80).odom_from_robot.x_m, 72.0, 1e-6);
}

TEST_F(Log, InterleavedPublishersAreToldApartAndOneCanBeNamed) {
    transform("base", "laser", Pose2{});
    for (int i = 0; i < 200; ++i) {
        const double t = 0.05 * i + 1.0;
        odometry(t, 0.5 * t);
        odometry(t + 0.01, 20.0);
        scan(t);
    }
    EXPECT_NEAR(read().at(100).odom_from_robot.x_m, 3.0, 1e-6);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("interleaved (paths 1 with 200, 2 with 200 poses); path 1 is used")));
    problems_.clear();
    LogOptions options;
    options.odom_path = 2;
    EXPECT_NEAR(read(options).at(100).odom_from_robot.x_m, 20.0, 1e-6);
    EXPECT_TRUE(problems_.empty());
    options.odom_path = 3;
    EXPECT_THAT(failure(options), HasSubstr("there is no path 3"));
}

/// A drive to and fro in a room, with odometry in the unit of which there are so many to a metre.
TEST_F(Log, OdometryInAnotherUnitIsNotUsed) {
    for (const double per_metre : {1.0, 100.0}) {
        log_ = {};
        problems_.clear();
        transform("base", "laser", Pose2{});
        RandomStream random({9});
        for (int i = 0; i < 150; ++i) {
            const double t = 0.2 * i + 1.0;
            const double x = 3.0 * std::sin(0.1 * t);
            RosLaserScan message = scan_message(t);
            const LaserScan scan = test::room_scan({x, 0.0, 0.0}, t, random);
            message.angle_min = static_cast<float>(scan.angle_min_rad);
            message.angle_increment = static_cast<float>(scan.angle_increment_rad);
            message.ranges = scan.ranges_m;
            odometry(t, per_metre * x);
            log_.add("/scan", at(t), message);
        }
        const auto frames = read();
        EXPECT_EQ(stream_->summary().has_odometry, per_metre == 1.0);
        if (per_metre == 1.0) {
            EXPECT_THAT(problems_, testing::IsEmpty());
        } else {
            EXPECT_THAT(problems_, ElementsAre(HasSubstr("is not used: it moves 10")));
            EXPECT_EQ(frames.at(100).odom_step, OdometryStep::unknown);
        }
    }
}

TEST_F(Log, AnglesAndRangesInOtherUnitsAreSaid) {
    RosLaserScan message = scan_message(1.0);
    message.ranges.assign(360, 2.0F);
    message.angle_min = -180.0F;
    message.angle_increment = 1.0F;
    log_.add("/scan", at(1.0), message);
    EXPECT_NEAR(read().at(0).scan.angle_increment_rad, std::numbers::pi / 180.0, 1e-9);
    EXPECT_THAT(stream_->summary().assumptions,
                testing::Contains(HasSubstr("the angles of 1 scans of /scan are taken")));
    message.angle_increment = 0.04F;
    log_.add("/scan", at(2.0), message);
    EXPECT_EQ(read().size(), 1U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("skipped a scan whose 360 beams cover 823 degrees")));
    log_ = {};
    message.angle_increment = 0.01F;
    message.range_max = 10000.0F;
    for (std::size_t beam = 0; beam < message.ranges.size(); ++beam) {
        message.ranges[beam] = 2000.0F + static_cast<float>(beam);
    }
    log_.add("/scan", at(1.0), message);
    problems_.clear();
    read();
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("half of the ranges are beyond 100 (up to 2359)")));
}

TEST_F(Log, SaysWhichOptionsHaveNoEffect) {
    scan(1.0);
    LogOptions options;
    options.height = HeightBand{0.1, 1.0};
    options.odom_delay_s = 0.1;
    read(options);
    EXPECT_THAT(stream_->summary().assumptions, testing::Contains(HasSubstr("--height has no effect")));
    EXPECT_THAT(stream_->summary().assumptions, testing::Contains(HasSubstr("--odom-delay has no effect")));
}

TEST_F(Log, ADelayOfTheOdometryCanBeNamed) {
    for (const double t : {1.0, 2.0, 3.0}) {
        odometry(t, t);
    }
    scan(2.0);
    LogOptions options;
    options.odom_delay_s = 0.25;
    EXPECT_NEAR(read(options).at(0).odom_from_robot.x_m, 2.25, 1e-9);
    EXPECT_NEAR(stream_->summary().odom_delay_removed_s, 0.25, 1e-9);
}

TEST_F(Log, WhereTimeStepsBackTheOdometryBesideTheScanCounts) {
    for (const auto& [stamp_s, x] : {std::pair{10.0, 0.0}, {10.4, 4.0}, {9.6, 5.0}, {10.2, 6.0}, {10.6, 7.0}}) {
        odometry(stamp_s, x);
        scan(stamp_s);
    }
    std::vector<double> positions;
    for (const SensorFrame& frame : read()) {
        positions.push_back(frame.odom_from_robot.x_m);
    }
    EXPECT_THAT(positions, ElementsAre(0.0, 4.0, 5.0, 6.0, 7.0));
}

TEST_F(Log, OfADrivingRobotAScanDoesNotWaitForThePoseAfterIt) {
    for (int step = 0; step < 250; ++step) {
        const double now_s = 10.0 + 0.02 * step;
        odometry(now_s, now_s);
        scan(now_s + 0.01);
    }
    const auto stream = open_live();
    std::optional<SensorFrame> last;
    for (int frame = 0; frame < 200; ++frame) {
        last = stream->next();
        ASSERT_TRUE(last);
    }
    EXPECT_EQ(stream->fraction_read(), 0.8) << "nothing after the scan was read";
    EXPECT_NEAR(last->odom_from_robot.x_m, 10.0 + 0.02 * 199 + 0.01, 1e-6) << "the motion goes on";
    EXPECT_EQ(last->odom_step, OdometryStep::measured);
    EXPECT_EQ(stream->summary().odom_frame, "odom");
    EXPECT_EQ(stream->summary().robot_frame, "base");
}

TEST_F(Log, OfADrivingRobotAScanWaitsHalfASecondForOdometryThatDoesNotCome) {
    for (int step = 0; step < 300; ++step) {
        const double now_s = 10.0 + 0.02 * step;
        scan(now_s);
        if (step < 200) {
            odometry(now_s, now_s);
        }
    }
    const auto stream = open_live();
    for (int frame = 0; frame < 270; ++frame) {
        ASSERT_TRUE(stream->next());
    }
    const double waiting = 500.0 * (1.0 - stream->fraction_read());
    EXPECT_NEAR(waiting, 500.0 - 470.0 - 26.0, 1.0) << "25 scans are half a second";
}

TEST_F(Log, OfADrivingRobotThreeSecondsAreLookedAtBeforeTheFirstFrame) {
    odometry(0.0, 0.0);
    for (int step = 0; step < 50; ++step) {
        scan(100.0 + 0.1 * step);
        odometry(100.0 + 0.1 * step, 0.1 * step);
    }
    const auto stream = open_live();
    EXPECT_NEAR(stream->fraction_read(), (1.0 + 2.0 * 31) / 101.0, 0.03);
}

TEST_F(Log, DeadOdometryDoesNotHoldUpScansForever) {
    odometry(0.0, 1.0);
    for (std::size_t i = 1; i <= 3 * MessageLogStream::max_waiting; ++i) {
        scan(0.1 * static_cast<double>(i));
    }
    const auto stream = open();
    ASSERT_TRUE(stream->next());
    EXPECT_LT(stream->fraction_read(), 0.5);
}

TEST_F(Log, ComposesTheMountingFromSeveralTransforms) {
    transform("base", "mast", Pose2{0.5, 0.0, std::numbers::pi / 2});
    transform("mast", "laser", Pose2{0.2, 0.1, 0.25});
    odometry(1.0, 0.0);
    scan(1.0);
    const SensorFrame frame = read().at(0);
    EXPECT_NEAR(frame.robot_from_laser.x_m, 0.4, 1e-9);
    EXPECT_NEAR(frame.robot_from_laser.y_m, 0.2, 1e-9);
    EXPECT_NEAR(frame.robot_from_laser.theta_rad, std::numbers::pi / 2 + 0.25, 1e-9);
    EXPECT_TRUE(stream_->summary().assumptions.empty());
}

/// The end point of a beam, seen from the robot. It must not depend on how the mounting is expressed.
TEST_F(Log, MirrorsAScanThatIsMountedUpsideDown) {
    const Eigen::Isometry3d base_from_laser = Eigen::Translation3d(0.3, -0.2, 0.5) *
                                              Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                              Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
    const Eigen::Quaterniond q(base_from_laser.linear());
    transform("base", "laser", RosPose{{0.3, -0.2, 0.5}, {q.x(), q.y(), q.z(), q.w()}});
    odometry(1.0, 0.0);
    scan(1.0);
    const SensorFrame frame = read().at(0);
    EXPECT_LT(frame.scan.angle_increment_rad, 0.0);
    for (std::size_t beam = 0; beam < 4; ++beam) {
        const double logged_rad = -1.0 + 0.5 * static_cast<double>(beam);
        const double range_m = static_cast<double>(frame.scan.ranges_m[beam]);
        const Eigen::Vector3d expected =
            base_from_laser * Eigen::Vector3d(range_m * std::cos(logged_rad), range_m * std::sin(logged_rad), 0.0);
        const double angle_rad = frame.scan.angle_rad(beam);
        const Point2 end =
            frame.robot_from_laser * Point2{range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)};
        EXPECT_NEAR(end.x_m, expected.x(), 1e-6);
        EXPECT_NEAR(end.y_m, expected.y(), 1e-6);
    }
}

TEST_F(Log, TakesOdometryFromTransforms) {
    transform("base_footprint", "laser", Pose2{0.1, 0.0, 0.0});
    for (const double t : {1.0, 2.0, 3.0}) {
        transform("map", "odom", Pose2{100.0, 0.0, 0.0}, t, "/tf");
        transform("odom", "base_footprint", Pose2{t, 0.0, 0.0}, t, "/tf");
        scan(t - 0.5, t);
    }
    const auto frames = read();
    EXPECT_NEAR(frames.at(1).odom_from_robot.x_m, 1.5, 1e-9);
    EXPECT_NEAR(frames.at(2).odom_from_robot.x_m, 2.5, 1e-9);
    EXPECT_NEAR(frames.at(2).robot_from_laser.x_m, 0.1, 1e-9);
    EXPECT_EQ(stream_->summary().odom_topic, "/tf");
}

TEST_F(Log, WithoutOdometryTheRobotStands) {
    scan(1.0);
    EXPECT_EQ(read().at(0).odom_from_robot, Pose2{});
    EXPECT_TRUE(stream_->summary().odom_topic.empty());
    EXPECT_THAT(stream_->summary().assumptions, testing::Contains(HasSubstr("no odometry")));
}

TEST_F(Log, ALaserWithoutTransformIsAtTheRobotsOriginUnlessTold) {
    odometry(1.0, 0.0);
    scan(1.0);
    EXPECT_EQ(read().at(0).robot_from_laser, Pose2{});
    EXPECT_THAT(stream_->summary().assumptions, ElementsAre(HasSubstr("no transform")));
    const Pose2 mounting{0.1, 0.2, 0.3};
    const Pose2 used = read(test::topics("", "", "", mounting)).at(0).robot_from_laser;
    EXPECT_NEAR(distance_m(used, mounting), 0.0, 1e-12);
    EXPECT_NEAR(used.theta_rad, 0.3, 1e-12);
    EXPECT_TRUE(stream_->summary().assumptions.empty());
}

TEST_F(Log, GroundTruthIsFoundByNameAndNeverTakenForOdometry) {
    for (const double t : {1.0, 2.0}) {
        odometry(t, 50.0 * t, "/ground_truth");
        odometry(t, t);
        scan(t - 0.5, t);
    }
    const auto frames = read();
    EXPECT_NEAR(frames.at(1).odom_from_robot.x_m, 1.5, 1e-9);
    ASSERT_TRUE(frames.at(1).world_from_robot);
    EXPECT_NEAR(frames.at(1).world_from_robot->x_m, 75.0, 1e-9);
    EXPECT_FALSE(frames.at(0).world_from_robot) << "there was no truth before it";
}

TEST_F(Log, TopicsAreChosenByOption) {
    scan(1.0);
    log_.add("/scan_rear", at(1.0), scan_message(1.0, "rear"));
    odometry(1.0, 1.0);
    odometry(1.0, 2.0, "/odometry/filtered");
    log_.add("/mocap", at(1.0), pose_message(at(1.0), "world", {3.0, 0.0, 0.0}));
    const auto frames = read(test::topics("/scan_rear", "/odometry/filtered", "/mocap"));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].odom_from_robot.x_m, 2.0);
    EXPECT_EQ(frames[0].world_from_robot.value().x_m, 3.0);
    EXPECT_EQ(read().size(), 1U);
    EXPECT_EQ(stream_->summary().scan_topic, "/scan");
    EXPECT_EQ(stream_->summary().odom_topic, "/odom");
}

TEST_F(Log, AnOptionThatNamesNoTopicSaysWhichThereAre) {
    scan(1.0);
    odometry(1.0, 1.0);
    EXPECT_THROW(open(test::topics("/odom")), UsageError);
    EXPECT_THAT(failure(test::topics("/scn")), HasSubstr("/scan"));
    EXPECT_THAT(failure(test::topics("", "/odo")), HasSubstr("/odom"));
    EXPECT_THAT(failure(test::topics("", "", "/truth")), HasSubstr("/odom"));
}

TEST_F(Log, ATopicThatBeginsLateIsFoundWhenAskedFor) {
    for (int t = 0; t < 60; ++t) {
        scan(t);
    }
    odometry(59.0, 5.0, "/late");
    scan(59.0);
    EXPECT_EQ(read(test::topics("", "/late")).back().odom_from_robot.x_m, 5.0);
}

TEST_F(Log, WithoutScansTheErrorNamesWhatThereIs) {
    EXPECT_THAT(failure(), HasSubstr("no messages"));
    odometry(1.0, 1.0);
    EXPECT_THAT(failure(), HasSubstr("/odom (nav_msgs/msg/Odometry)"));
}

TEST_F(Log, ReadingsAreWhatTheMessageDefinitionSays) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    RosLaserScan message = scan_message(1.0);
    message.ranges = {5.0F, 0.0F, 0.05F, 11.0F, inf, -inf, std::nanf("")};
    message.angle_increment = -0.5F;
    log_.add("/scan", second, message);
    scan(2.0);
    const auto frames = read();
    ASSERT_EQ(frames.size(), 2U);
    const std::vector<float>& ranges = frames[0].scan.ranges_m;
    EXPECT_EQ(ranges[0], 5.0F);
    EXPECT_THAT((std::vector<float>{ranges[3], ranges[4]}), testing::Each(LaserScan::no_return));
    EXPECT_THAT((std::vector<float>{ranges[1], ranges[2], ranges[5], ranges[6]}), testing::Each(testing::IsNan()));
    EXPECT_LT(frames[0].scan.angle_increment_rad, 0.0);
    EXPECT_EQ(frames[1].scan.ranges_m.size(), 4U);
}

TEST_F(Log, EachScanIsPlacedByItsOwnFrame) {
    transform("base", "front", Pose2{0.3, 0.0, 0.0});
    transform("base", "rear", Pose2{-0.2, 0.0, 3.0});
    odometry(1.0, 0.0);
    scan_in("front", 1.0);
    scan_in("rear", 1.1);
    scan_in("/front", 1.2);
    scan_in("lost", 1.3);
    const auto frames = read();
    ASSERT_EQ(frames.size(), 3U) << "a scan that no transform places cannot be used";
    EXPECT_NEAR(frames[0].robot_from_laser.x_m, 0.3, 1e-9);
    EXPECT_NEAR(frames[1].robot_from_laser.x_m, -0.2, 1e-9);
    EXPECT_NEAR(frames[2].robot_from_laser.x_m, 0.3, 1e-9);
    EXPECT_THAT(stream_->summary().assumptions, ElementsAre(HasSubstr("in 3 frames (front, rear, lost)")));
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("a scan in the frame 'lost'")));
}

TEST_F(Log, AGivenLaserPoseIsForAllFrames) {
    transform("base", "front", Pose2{0.3, 0.0, 0.0});
    odometry(1.0, 0.0);
    scan_in("front", 1.0);
    scan_in("rear", 1.1);
    const auto frames = read(test::topics("", "", "", Pose2{0.1, 0.0, 0.0}));
    EXPECT_NEAR(frames.at(0).robot_from_laser.x_m, 0.1, 1e-9);
    EXPECT_NEAR(frames.at(1).robot_from_laser.x_m, 0.1, 1e-9);
}

TEST_F(Log, AMountingThatComesLateIsKnownFromTheStart) {
    for (int t = 1; t < 60; ++t) {
        odometry(t, 0.0);
        scan(t);
    }
    transform("base", "laser", Pose2{0.3, 0.0, 0.0}, 60.0);
    EXPECT_NEAR(read().at(0).robot_from_laser.x_m, 0.3, 1e-9);
    EXPECT_TRUE(stream_->summary().assumptions.empty());
}

TEST_F(Log, OdometryInTransformsNeedsNoLaserInTheTree) {
    for (const double t : {1.0, 2.0, 3.0}) {
        transform("base", "arm", Pose2{0.0, 0.1 * t, 0.0}, t, "/tf");
        transform("odom", "base", Pose2{t, 0.0, 0.0}, t, "/tf");
        scan(t);
    }
    for (const std::string topic : {"", "/tf"}) {
        const auto frames = read(test::topics("", topic, "", Pose2{0.2, 0.0, 0.0}));
        EXPECT_NEAR(frames.at(2).odom_from_robot.x_m, 3.0, 1e-9);
        EXPECT_NEAR(frames.at(2).robot_from_laser.x_m, 0.2, 1e-9);
        EXPECT_TRUE(stream_->summary().assumptions.empty());
        EXPECT_EQ(read(test::topics("", topic)).at(2).robot_from_laser, Pose2{});
        EXPECT_THAT(stream_->summary().assumptions,
                    ElementsAre(HasSubstr("no transform from the laser 'laser' to 'base'")));
    }
}

TEST_F(Log, TransformsWithoutOdometryAreRefusedWhereTheyAreAskedFor) {
    transform("base", "arm", Pose2{0.2, 0.0, 0.0});
    scan(1.0);
    EXPECT_THAT(failure(test::topics("", "/tf_static")), HasSubstr("'/tf_static' has no odometry"));
    EXPECT_EQ(read().size(), 1U);
    EXPECT_FALSE(stream_->summary().has_odometry);
}

class Robots : public Log {
protected:
    Robots() {
        for (const auto& [robot, speed] : {std::pair{std::string("/robot1"), 1.0}, {std::string("/robot2"), 2.0}}) {
            transform("base", "laser", Pose2{0.1 * speed, 0.0, 0.0}, 0.0, robot + "/tf_static");
            for (int i = 1; i < 20; ++i) {
                transform("odom", "base", Pose2{speed * i, 0.0, 0.0}, i, robot + "/tf");
                scan_in("laser", i, robot + "/scan");
            }
        }
    }
    void expect_robot(double speed) {
        EXPECT_NEAR(frames_.at(10).odom_from_robot.x_m, speed * 11.0, 1e-9);
        EXPECT_NEAR(frames_.at(10).robot_from_laser.x_m, 0.1 * speed, 1e-9);
    }
    std::vector<SensorFrame> frames_;
};

TEST_F(Robots, AScanBringsTheTransformsOfItsOwnRobot) {
    frames_ = read(test::topics("/robot1/scan"));
    expect_robot(1.0);
    frames_ = read(test::topics("/robot2/scan"));
    expect_robot(2.0);
    EXPECT_EQ(stream_->summary().odom_topic, "/robot2/tf");
}

TEST_F(Robots, AScanBringsTheOdometryOfItsOwnRobot) {
    for (int i = 1; i < 20; ++i) {
        odometry(i, 3.0 * i, "/robot1/odom");
        odometry(i, 2.0 * i, "/robot2/odom");
    }
    frames_ = read(test::topics("/robot2/scan"));
    expect_robot(2.0);
    EXPECT_EQ(stream_->summary().odom_topic, "/robot2/odom");
}

TEST_F(Robots, TheRobotCanBeNamed) {
    LogOptions options;
    options.robot = "robot2";
    frames_ = read(options);
    expect_robot(2.0);
    options.robot = "robot3";
    EXPECT_THAT(failure(options),
                HasSubstr("no scans of a robot 'robot3'; its scan topics are /robot1/scan, /robot2/scan"));
}

TEST_F(Log, RobotsWithoutTransformsAreToldApartByTheirTopics) {
    drive("/a/scan", "/a/odom", 1.0);
    drive("/b/scan", "/b/odom", 2.0);
    EXPECT_NEAR(read(test::topics("/b/scan")).at(10).odom_from_robot.x_m, 22.0, 1e-9);
}

TEST_F(Log, RobotsInOneTreeAreToldApartByTheirFrames) {
    for (int i = 1; i < 20; ++i) {
        transform("a/odom", "a/base", Pose2{1.0 * i, 0.0, 0.0}, i, "/tf");
        transform("b/odom", "b/base", Pose2{2.0 * i, 0.0, 0.0}, i, "/tf");
        scan_in("b/laser", i);
    }
    EXPECT_NEAR(read().at(10).odom_from_robot.x_m, 22.0, 1e-9);
}

TEST_F(Log, AMountingWithoutRotationIsSaid) {
    transform("base", "laser", RosPose{{0.3, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}});
    odometry(1.0, 0.0);
    scan(1.0);
    EXPECT_EQ(read().at(0).robot_from_laser, (Pose2{0.3, 0.0, 0.0}));
    EXPECT_THAT(stream_->summary().assumptions, ElementsAre(HasSubstr("base -> laser has the rotation 0,0,0,0")));
    EXPECT_TRUE(problems_.empty());
}

TEST_F(Log, OdometryWithoutRotationIsSkippedAndCounted) {
    const auto odometry_without_rotation = [&](double stamp_s) {
        RosOdometry message = odometry_message(at(stamp_s), "odom", "base", {50.0, 0.0, 0.0});
        message.pose.orientation = {0.0, 0.0, 0.0, 0.0};
        log_.add("/odom", at(stamp_s), message);
    };
    transform("base", "laser", Pose2{});
    odometry_without_rotation(1.0);
    scan(1.5);
    EXPECT_FALSE(open()->summary().has_odometry);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("the rotation of all its 1 poses is 0,0,0,0")));
    problems_.clear();
    odometry(1.0, 1.0);
    odometry_without_rotation(1.4);
    odometry(2.0, 2.0);
    EXPECT_NEAR(read().at(0).odom_from_robot.x_m, 1.5, 1e-9);
    EXPECT_EQ(stream_->summary().problems, 2U);
    EXPECT_THAT(problems_, testing::Each(HasSubstr("a pose whose rotation is 0,0,0,0")));
}

/// Scans of a robot that moves, in odometry at 10 Hz that is as it is given.
class Driven : public Log {
protected:
    void drive(const std::function<double(double)>& x_at, double odometry_ahead_s = 0.0,
               const std::string& odom = "/odom") {
        transform("base", "laser", Pose2{});
        for (int i = 10; i < 100; ++i) {
            const double t = 0.1 * i;
            RosLaserScan message = scan_message(t);
            message.ranges = {static_cast<float>(t), 9.0F - static_cast<float>(t) / 2.0F, 3.0F, 4.0F};
            log_.add("/scan", at(t), message);
            const std::int64_t stamp_ns = at(t + odometry_ahead_s);
            log_.add(odom, at(t), odometry_message(stamp_ns, "odom", "base", {x_at(t), 0.0, 0.0}));
        }
    }
};

TEST_F(Driven, OdometryThatNeverMovesIsNotBelieved) {
    drive([](double) { return 3.0; });
    const auto frames = read();
    EXPECT_FALSE(stream_->summary().has_odometry);
    EXPECT_EQ(frames.at(5).odom_from_robot, Pose2{});
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("the odometry /odom is not used: it never moves")));
    EXPECT_THAT(stream_->summary().first_problems, testing::ElementsAreArray(problems_));
}

TEST_F(Driven, OtherOdometryIsUsedInItsPlace) {
    drive([](double) { return 3.0; });
    for (int i = 10; i < 100; ++i) {
        transform("odom", "base", Pose2{0.01 * i, 0.0, 0.0}, 0.1 * i, "/tf");
    }
    EXPECT_NEAR(read().at(40).odom_from_robot.x_m, 0.5, 1e-9);
    EXPECT_EQ(stream_->summary().odom_topic, "/tf");
    EXPECT_EQ(problems_.size(), 1U);
}

TEST_F(Driven, TheOdometryCanBeLeftOut) {
    drive([](double t) { return t; });
    LogOptions options;
    options.with_odometry = false;
    EXPECT_EQ(read(options).at(5).odom_from_robot, Pose2{});
    EXPECT_FALSE(stream_->summary().has_odometry);
    EXPECT_THAT(stream_->summary().assumptions, ElementsAre(HasSubstr("as was asked for")));
    EXPECT_TRUE(problems_.empty());
}

TEST_F(Driven, OdometryThatStartsAgainAtZeroGoesOn) {
    drive([](double t) { return 0.5 * (t < 5.0 ? t : t - 5.0); });
    const auto frames = read();
    EXPECT_NEAR(frames.at(30).odom_from_robot.x_m, 2.0, 1e-6);
    EXPECT_NEAR(frames.at(80).odom_from_robot.x_m, 4.5, 1e-6);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("/odom jumps by 2.45 m and 0.00 rad in 0.10 s, to its origin")));
}

TEST_F(Driven, AnotherClockIsFoundByTheTimesOfRecordingAndTakenOff) {
    for (const double ahead_s : {4.3, -97200.0}) {
        log_ = {};
        drive([](double t) { return t; }, ahead_s);
        EXPECT_NEAR(read().at(40).odom_from_robot.x_m, 5.0, 1e-6);
        EXPECT_TRUE(problems_.empty());
        EXPECT_THAT(stream_->summary().assumptions,
                    ElementsAre(HasSubstr("that of the scans, as the times of recording")));
    }
}

TEST_F(Driven, OdometryOfAnotherTimeIsNotUsed) {
    drive([](double t) { return t; }, 0.0, "/other");
    for (int i = 0; i < 90; ++i) {
        log_.add("/odom", at(5000.0 + 0.1 * i),
                 odometry_message(at(5000.0 + 0.2 * i), "odom", "base", {0.1 * i, 0.0, 0.0}));
    }
    read(test::topics("", "/odom"));
    EXPECT_FALSE(stream_->summary().has_odometry);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("share no moment")));
}

TEST_F(Log, AMissThatReadsTheMaximumRangeIsNoReturnUnlessToldOtherwise) {
    for (int i = 0; i < 20; ++i) {
        RosLaserScan message = scan_message(0.1 * i + 1.0);
        message.ranges = {1.0F, 10.0F, 3.0F, 4.0F};
        log_.add("/scan", at(0.1 * i + 1.0), message);
    }
    odometry(1.0, 1.0);
    transform("base", "laser", Pose2{});
    EXPECT_THAT(read().at(0).scan.ranges_m, ElementsAre(1.0F, LaserScan::no_return, 3.0F, 4.0F));
    EXPECT_THAT(stream_->summary().assumptions, ElementsAre(HasSubstr("10.000 m (20 of 80 readings, 25.0 %)")));
    LogOptions told;
    told.no_return_m = {0.0};
    EXPECT_THAT(read(told).at(0).scan.ranges_m, ElementsAre(1.0F, 10.0F, 3.0F, 4.0F));
    EXPECT_TRUE(stream_->summary().assumptions.empty());
    told.no_return_m = {3.0};
    EXPECT_THAT(read(told).at(0).scan.ranges_m,
                ElementsAre(1.0F, LaserScan::no_return, LaserScan::no_return, LaserScan::no_return));
    told.no_return_m = {0.0};
    told.range_max_m = 3.5;
    EXPECT_THAT(read(told).at(0).scan.ranges_m, ElementsAre(1.0F, LaserScan::no_return, 3.0F, LaserScan::no_return));
    EXPECT_EQ(read(told).at(0).scan.range_max_m, 3.5);
}

TEST_F(Log, SkipsMessagesThatCannotBeUsed) {
    odometry(1.0, 1.0);
    scan(1.0);
    log_.add_bytes("/scan", "cdr", RosLaserScan::type_name, at(1.1), std::vector<std::byte>(7));
    log_.add_bytes("/odom", "cdr", RosOdometry::type_name, at(1.1), std::vector<std::byte>(7));
    RosLaserScan empty = scan_message(1.2);
    empty.ranges.clear();
    log_.add("/scan", at(1.2), empty);
    RosLaserScan without_angles = scan_message(1.3);
    without_angles.angle_increment = 0.0F;
    log_.add("/scan", at(1.3), without_angles);
    EXPECT_EQ(read().size(), 1U);
    EXPECT_EQ(stream_->summary().problems, 4U);
    EXPECT_THAT(problems_.at(0), HasSubstr("/scan (sensor_msgs/msg/LaserScan): skipped a damaged message"));
}

TEST_F(Log, AStampOfZeroIsTheTimeOfRecording) {
    scan(0.0, 7.0);
    EXPECT_EQ(read().at(0).scan.stamp_ns, 7 * second);
}

/// A robot with a lidar in front and one behind, whose scans are taken at other times.
class TwoLidars : public Log {
protected:
    void drive() {
        transform("base", "front", Pose2{0.3, 0.0, 0.0});
        transform("base", "rear", Pose2{-0.3, 0.0, std::numbers::pi});
        for (int i = 0; i < 20; ++i) {
            odometry(i, i);
            scan_in("front", i + 0.25, "/front/scan");
            scan_in("rear", i + 0.75, "/rear/scan");
        }
        odometry(20, 20);
    }
    static LogOptions both() {
        LogOptions options;
        options.scan_topic = "/front/scan,/rear/scan";
        return options;
    }
};

TEST_F(TwoLidars, AreEachPlacedByTheirOwnMountingAndStamp) {
    drive();
    const auto frames = read(both());
    ASSERT_EQ(frames.size(), 40U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool is_rear = i % 2 == 1;
        EXPECT_EQ(frames[i].lidar, is_rear ? 1U : 0U);
        EXPECT_NEAR(frames[i].robot_from_laser.x_m, is_rear ? -0.3 : 0.3, 1e-9);
        EXPECT_NEAR(frames[i].odom_from_robot.x_m, 0.25 + 0.5 * static_cast<double>(i), 1e-9);
    }
    EXPECT_EQ(stream_->summary().scan_topic, "/front/scan");
    EXPECT_THAT(stream_->summary().more_scan_topics, ElementsAre("/rear/scan"));
    EXPECT_TRUE(problems_.empty());
}

TEST_F(TwoLidars, AreNotUsedTogetherUnlessAskedFor) {
    drive();
    EXPECT_EQ(read().size(), 20U);
    EXPECT_EQ(stream_->summary().scan_topic, "/rear/scan");
    EXPECT_THAT(stream_->summary().assumptions,
                ElementsAre(HasSubstr("several scan topics"), HasSubstr("--scan-topic /rear/scan,/front/scan")));
}

TEST_F(TwoLidars, OfWhichOneHasNoPlaceAreUsedWithoutIt) {
    drive();
    for (int i = 0; i < 20; ++i) {
        scan_in("unknown", i + 0.5, "/side/scan");
    }
    LogOptions options;
    options.scan_topic = "/front/scan,/side/scan";
    EXPECT_EQ(read(options).size(), 20U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("/side/scan are not used: no transform places their frame")));
}

TEST_F(TwoLidars, OfWhichOneHasAnotherClockAreUsedWithoutIt) {
    drive();
    transform("base", "side", Pose2{0.0, 0.3, 0.0});
    for (int i = 0; i < 20; ++i) {
        log_.add("/side/scan", at(i + 0.5), scan_message(i + 1000.5, "side"));
    }
    LogOptions options;
    options.scan_topic = "/front/scan,/side/scan";
    EXPECT_EQ(read(options).size(), 20U);
    EXPECT_THAT(problems_, ElementsAre(HasSubstr("their clock differs from that of /front/scan by 1000")));
}

TEST_F(TwoLidars, AreNotPlacedByOnePose) {
    drive();
    LogOptions options = both();
    options.laser_pose = Pose2{0.1, 0.0, 0.0};
    EXPECT_THAT(failure(options), HasSubstr("--laser-pose is the pose of one lidar"));
    options = both();
    options.scan_topic += ",/none";
    EXPECT_THAT(failure(options), HasSubstr("no scan topic '/none'"));
}

}  // namespace
}  // namespace ddtool
