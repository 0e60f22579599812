#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ddtool/base/error.hpp"
#include "ddtool/base/random.hpp"
#include "logs/stream/gyro_odometry.hpp"
#include "logs/stream/gyro_survey.hpp"
#include "logs/stream/gyro_trial.hpp"
#include "logs/stream/message_log_stream.hpp"
#include "message_log.hpp"
#include "swept_scans.hpp"

namespace ddtool {
namespace {

using test::SweptScans;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t ms = 1'000'000;

TEST(GyroTrack, AddsUpRatesBetweenAnyTwoTimes) {
    GyroTrack gyro;
    for (int i = 0; i <= 100; ++i) {
        gyro.add(i * 10 * ms, 0.5);
    }
    EXPECT_NEAR(gyro.turn_rad(123 * ms, 877 * ms).value(), 0.5 * 0.754, 1e-9);
    EXPECT_TRUE(gyro.reaches(1000 * ms));
    EXPECT_FALSE(gyro.reaches(1001 * ms));
    EXPECT_FALSE(gyro.turn_rad(500 * ms, 1001 * ms).has_value());
    EXPECT_FALSE(gyro.turn_rad(-1 * ms, 500 * ms).has_value());
}

TEST(GyroTrack, KnowsNoTurnAcrossAGapOrAfterAStepBackOfTheStamps) {
    GyroTrack gyro;
    for (const int at_ms : {0, 100, 200, 600, 700}) {
        gyro.add(at_ms * ms, 1.0);
    }
    EXPECT_FALSE(gyro.turn_rad(150 * ms, 650 * ms).has_value());
    EXPECT_FALSE(gyro.turn_rad(150 * ms, 400 * ms).has_value());
    EXPECT_NEAR(gyro.turn_rad(600 * ms, 650 * ms).value(), 0.05, 1e-9);
    gyro.add(100 * ms, 1.0);
    EXPECT_FALSE(gyro.turn_rad(600 * ms, 650 * ms).has_value());
}

TEST(GyroOdometry, TakesTheWayFromTheWheelsAndTheTurnFromTheGyro) {
    GyroOdometry odometry;
    odometry.use(1.0, 0.02);
    StampedPose last;
    for (int i = 0; i <= 200; ++i) {
        // an arc of 1 m/s and 0.5 rad/s, whose turn the wheels do not notice
        odometry.add_rate(i * 10 * ms, 0.52);
        odometry.add_pose({i * 10 * ms, {0.01 * i, 0.0, 0.0}});
        while (const auto pose = odometry.next(false)) {
            last = *pose;
        }
    }
    EXPECT_NEAR(last.pose.theta_rad, 1.0, 1e-6);
    EXPECT_NEAR(last.pose.x_m, 2.0 * std::sin(1.0), 1e-3);
    EXPECT_NEAR(last.pose.y_m, 2.0 * (1.0 - std::cos(1.0)), 1e-3);
}

TEST(GyroOdometry, FollowsTheBiasWhileTheWheelsStandStill) {
    GyroOdometry odometry;
    odometry.use(1.0, 0.0);
    double heading_rad = 0.0;
    double x_m = 0.0;
    for (int i = 0; i <= 4000; ++i) {
        odometry.add_rate(i * 10 * ms, 0.01);
        x_m += i > 2000 ? 0.01 : 0.0;
        odometry.add_pose({i * 10 * ms, {x_m, 0.0, 0.0}});
        while (const auto pose = odometry.next(false)) {
            heading_rad = pose->pose.theta_rad;
        }
    }
    EXPECT_LT(std::abs(heading_rad), 0.1 * 0.01 * 20.0);
}

TEST(GyroOdometry, TakesTheWheelsTurnsWhereTheGyroIsSilentAndWaitsForItOnlySoLong) {
    GyroOdometry odometry;
    odometry.use(1.0, 0.0);
    odometry.add_rate(0, 0.0);
    std::size_t given = 0;
    double heading_rad = 0.0;
    for (int i = 0; i < 20; ++i) {
        odometry.add_pose({i * 100 * ms, {0.0, 0.0, 0.1 * i}});
        while (const auto pose = odometry.next(false)) {
            ++given;
            heading_rad = pose->pose.theta_rad;
        }
    }
    EXPECT_EQ(given, 15U);  // the last half second may still get its turns
    EXPECT_NEAR(heading_rad, 1.4, 1e-9);
    while (odometry.next(true)) {
        ++given;
    }
    EXPECT_EQ(given, 20U);
}

TEST(GyroOdometry, LeavesThePosesUntilItIsUsed) {
    GyroOdometry odometry;
    odometry.add_rate(0, 0.3);
    odometry.add_rate(1000 * ms, 0.3);
    odometry.add_pose({0, {1.0, 2.0, 3.0}});
    odometry.add_pose({500 * ms, {1.5, 2.5, -3.0}});
    EXPECT_EQ(odometry.next(false)->pose, (Pose2{1.0, 2.0, 3.0}));
    EXPECT_EQ(odometry.next(false)->pose, (Pose2{1.5, 2.5, -3.0}));
}

/// What scans of a robot that looks to and fro say of its gyro, if wheels and gyro measure the true turns so.
std::optional<GyroVerdict> verdict_of(double wheels_gain, double gyro_gain, double gyro_bias_rad_per_s,
                                      double gyro_noise_rad_per_s = 0.0, double speed = 1.0) {
    GyroTrial trial;
    GyroTrack gyro;
    RandomStream random{5};
    int rates = 0;
    Pose2 odometry;
    Pose2 before = SweptScans::robot_at(0.0);
    for (int i = 0; i < 200; ++i) {
        const double t_s = speed * SweptScans::scan_every_s * i;
        for (; 0.01 * rates <= SweptScans::scan_every_s * i; ++rates) {
            const double rate = speed * 1.5 * std::cos(1.5 * speed * 0.01 * rates);
            gyro.add(rates * 10 * ms, gyro_gain * rate + gyro_bias_rad_per_s + gyro_noise_rad_per_s * random.normal());
        }
        SensorFrame frame = SweptScans{.order = 0}.scan_at(t_s);
        frame.scan.stamp_ns = std::llround(1e9 * SweptScans::scan_every_s * i);
        Pose2 motion = between(before, SweptScans::robot_at(t_s));
        before = SweptScans::robot_at(t_s);
        motion.theta_rad *= wheels_gain;
        odometry = odometry * motion;
        frame.odom_from_robot = odometry;
        trial.add(frame, gyro);
    }
    return trial.verdict();
}

TEST(GyroTrial, PrefersAGyroToWheelsThatSlip) {
    const GyroVerdict verdict = verdict_of(1.05, 1.0, 0.02).value();
    EXPECT_TRUE(verdict.is_better);
    EXPECT_EQ(verdict.scale, 1.0);
    EXPECT_NEAR(verdict.bias_rad_per_s, 0.02, 0.002);
    EXPECT_LT(verdict.error_rad, 0.5 * verdict.odometry_error_rad);
}

TEST(GyroTrial, FindsDegreesAndSensorsThatAreMountedUpsideDown) {
    const double per_degree = 180.0 / std::numbers::pi;
    EXPECT_EQ(verdict_of(1.05, -1.0, 0.01)->scale, -1.0);
    EXPECT_NEAR(verdict_of(1.05, per_degree, 0.5)->scale, 1.0 / per_degree, 1e-9);
    EXPECT_NEAR(verdict_of(1.05, -per_degree, 0.5)->scale, -1.0 / per_degree, 1e-9);
    EXPECT_TRUE(verdict_of(1.05, -per_degree, 0.5)->is_better);
}

TEST(GyroTrial, FindsTheUnitWhereTheRobotSeldomTurns) {
    GyroTrial trial;
    GyroTrack gyro;
    RandomStream random{5};
    // it stands for five seconds of six, and turns at 0.5 rad/s in the sixth
    const auto heading_at = [](double t_s) {
        return 0.5 * (std::floor(t_s / 6.0) + std::clamp(std::fmod(t_s, 6.0), 0.0, 1.0));
    };
    int rates = 0;
    for (int i = 0; i < 300; ++i) {
        const double t_s = 0.2 * i;
        for (; 0.01 * rates <= t_s; ++rates) {
            const double rate = 100.0 * (heading_at(0.01 * rates) - heading_at(0.01 * (rates - 1)));
            gyro.add(rates * 10 * ms, -180.0 / std::numbers::pi * rate + 0.05 * random.normal());
        }
        SensorFrame frame = SweptScans::scan_at(Pose2{0.0, 0.0, heading_at(t_s)});
        frame.scan.stamp_ns = i * 200 * ms;
        frame.odom_from_robot = {0.0, 0.0, 1.1 * heading_at(t_s)};
        trial.add(frame, gyro);
    }
    const GyroVerdict verdict = trial.verdict().value();
    EXPECT_NEAR(verdict.scale, -std::numbers::pi / 180.0, 1e-9);
    EXPECT_TRUE(verdict.is_better);
}

TEST(GyroTrial, KeepsWheelsThatAreAsGoodAndTakesNoGyroThatDoesNotFit) {
    EXPECT_FALSE(verdict_of(1.0, 1.0, 0.01)->is_better);
    EXPECT_FALSE(verdict_of(1.0, 1.0, 0.0, 0.3)->is_better);
    for (const double gain : {0.0, 0.5}) {
        const GyroVerdict verdict = verdict_of(1.05, gain, 0.0).value();
        EXPECT_FALSE(verdict.fits) << gain;
        EXPECT_FALSE(verdict.is_better) << gain;
    }
    EXPECT_FALSE(verdict_of(1.05, 1.0, 0.0, 0.0, 0.0).has_value());
}

RosImu imu_message(std::int64_t stamp_ns, const Eigen::Vector3d& rate, const Eigen::Vector3d& acceleration) {
    RosImu message;
    message.header = {{stamp_ns}, "imu"};
    message.angular_velocity = {rate.x(), rate.y(), rate.z()};
    message.linear_acceleration = {acceleration.x(), acceleration.y(), acceleration.z()};
    return message;
}

TEST(GyroSurvey, KnowsWhatIsUpByGravityAlone) {
    const auto upwards = [](const Eigen::Vector3d& acceleration) {
        GyroSurvey survey;
        ImuReading reading;
        reading.acceleration_m_per_s2 = acceleration;
        survey.add(reading, 0);
        survey.add(reading, 10 * ms);
        return survey.upwards();
    };
    EXPECT_NEAR(upwards({0.0, 6.9, -6.9}).value().y(), std::sqrt(0.5), 1e-9);
    EXPECT_FALSE(upwards({0.0, 0.0, 0.1}).has_value());
    EXPECT_FALSE(upwards({0.0, 0.0, 25.0}).has_value());
}

/// A log of a robot whose wheels turn 8 % too far, with an inertial sensor.
struct ImuLog {
    Eigen::Matrix3d robot_from_imu = Eigen::Matrix3d::Identity();
    bool has_transform = true;
    bool has_gravity = true;
    double gap_from_s = 1e9;
    std::string topic = "/imu/data";

    [[nodiscard]] test::MessageLog messages() const {
        test::MessageLog log;
        log.add("/tf_static", 0, transform_message(0, "base", "laser", {0.2, 0.0, 0.0}));
        if (has_transform) {
            const Eigen::Quaterniond turn(robot_from_imu);
            RosTFMessage message = transform_message(0, "base", "imu", {});
            message.transforms.front().transform.orientation = {turn.x(), turn.y(), turn.z(), turn.w()};
            log.add("/tf_static", 0, message);
        }
        Pose2 odometry;
        for (int i = 0; i <= 4000; ++i) {
            const double t_s = 0.01 * i;
            const std::int64_t stamp_ns = i * 10 * ms;
            if (t_s < gap_from_s || t_s > gap_from_s + 2.0) {
                const Eigen::Vector3d rate(0.01, 0.01, 1.5 * std::cos(1.5 * t_s) + 0.03);
                log.add(topic, stamp_ns,
                        imu_message(stamp_ns, robot_from_imu.transpose() * rate,
                                    robot_from_imu.transpose() * Eigen::Vector3d(0.0, 0.0, has_gravity ? 9.8 : 0.0)));
            }
            if (i % 2 == 0) {
                Pose2 motion = between(SweptScans::robot_at(t_s - 0.02), SweptScans::robot_at(t_s));
                motion.theta_rad *= 1.08;
                odometry = i == 0 ? SweptScans::robot_at(0.0) : odometry * motion;
                log.add("/odom", stamp_ns, odometry_message(stamp_ns, "odom", "base", odometry));
            }
            if (i % 20 == 0) {
                log.add("/scan", stamp_ns, scan_message(SweptScans{.order = 0}.scan_at(t_s).scan, "laser"));
            }
        }
        return log;
    }
};

struct ReadImuLog {
    double largest_error_rad = 0.0;  ///< of the turn between two scans
    LogSummary summary;
};

ReadImuLog read_imu_log(const ImuLog& imu, const std::string& imu_topic = "",
                        MessageLogStream::Opening opening = MessageLogStream::Opening::twice) {
    const test::MessageLog log = imu.messages();
    LogOptions options;
    options.imu_topic = imu_topic;
    MessageLogStream stream([&](const LogProblemHandler&) { return log.open(); }, opening, "test", "log", options,
                            [](const LogProblem&) {});
    ReadImuLog read;
    std::optional<SensorFrame> before;
    while (std::optional<SensorFrame> frame = stream.next()) {
        const auto true_pose = [](const SensorFrame& at) {
            return SweptScans::robot_at(1e-9 * static_cast<double>(at.scan.stamp_ns));
        };
        if (before) {
            const double turn = between(before->odom_from_robot, frame->odom_from_robot).theta_rad;
            const double truth = between(true_pose(*before), true_pose(*frame)).theta_rad;
            read.largest_error_rad = std::max(read.largest_error_rad, std::abs(wrap_angle(turn - truth)));
        }
        before = std::move(frame);
    }
    read.summary = stream.summary();
    return read;
}

const double slip_rad = 0.08 * 1.5 * 0.2;  // of the wheels between two scans

TEST(Imu, GivesTheTurnsWhereTheWheelsSlip) {
    const ReadImuLog read = read_imu_log({});
    EXPECT_LT(read.largest_error_rad, 0.1 * slip_rad);
    EXPECT_EQ(read.summary.imu_topic, "/imu/data");
    EXPECT_THAT(read.summary.assumptions, ElementsAre(HasSubstr("the turns are those of the gyro in /imu/data")));
    EXPECT_EQ(read.summary.problems, 0U);
}

TEST(Imu, MayBeMountedInAnyDirection) {
    using Eigen::AngleAxisd;
    const Eigen::Matrix3d upside_down = AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Eigen::Matrix3d on_its_side = AngleAxisd(1.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
    for (const Eigen::Matrix3d& robot_from_imu : {upside_down, on_its_side}) {
        for (const bool has_transform : {true, false}) {
            const ReadImuLog read = read_imu_log(
                {.robot_from_imu = robot_from_imu, .has_transform = has_transform, .has_gravity = !has_transform});
            EXPECT_LT(read.largest_error_rad, 0.1 * slip_rad) << has_transform;
        }
    }
    // nothing tells that it is upside down but the scans
    const ReadImuLog read = read_imu_log({.robot_from_imu = upside_down, .has_transform = false, .has_gravity = false});
    EXPECT_LT(read.largest_error_rad, 0.1 * slip_rad);
    EXPECT_THAT(read.summary.assumptions, Contains(HasSubstr("with the opposite sign")));
}

TEST(Imu, IsLeftOutOnRequestAndReplacedByTheWheelsInAGap) {
    const ReadImuLog without = read_imu_log({}, "none");
    EXPECT_GT(without.largest_error_rad, 0.9 * slip_rad);
    EXPECT_EQ(without.summary.imu_topic, "");
    EXPECT_THAT(without.summary.assumptions, IsEmpty());
    const ReadImuLog gap = read_imu_log({.gap_from_s = 20.0});
    EXPECT_LT(gap.largest_error_rad, 1.2 * slip_rad);
    EXPECT_EQ(gap.summary.imu_topic, "/imu/data");
}

TEST(Imu, IsJudgedOnTheWayInALogThatIsReadOnce) {
    const ReadImuLog read = read_imu_log({}, "", MessageLogStream::Opening::once);
    EXPECT_EQ(read.summary.imu_topic, "/imu/data");
}

TEST(Imu, HasToBeInTheLogIfItIsNamed) {
    EXPECT_THROW(read_imu_log({}, "/other"), UsageError);
    EXPECT_EQ(read_imu_log({}, "/imu/data").summary.imu_topic, "/imu/data");
}

}  // namespace
}  // namespace ddtool
