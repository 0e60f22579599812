#include "logs/stream/carmen_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "compressed_text.hpp"
#include "ddtool/base/error.hpp"
#include "log_topics.hpp"
#include "room_scan.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

std::string flaser(const std::string& ranges, double x, const std::string& time) {
    return "FLASER 3 " + ranges + " 0 0 0 " + std::to_string(x) + " 0 0 " + time + " host 0.0\n";
}

const std::string offset_param = "PARAM robot_frontlaser_offset 0.25 host 0\n";

class CarmenLog : public testing::Test {
protected:
    std::unique_ptr<LogStream> open(const std::string& content, const LogOptions& options = {}) {
        write_file(folder_ / "log", content);
        return open_log(folder_ / "log", options, [this](const LogProblem& problem) { problems_.push_back(problem); });
    }
    std::vector<SensorFrame> read(LogStream& stream) {
        std::vector<SensorFrame> frames;
        while (auto frame = stream.next()) {
            frames.push_back(std::move(*frame));
        }
        return frames;
    }
    std::vector<SensorFrame> read(const std::string& content) { return read(*open(content)); }

    test::TemporaryFolder folder_;
    std::vector<LogProblem> problems_;
};

TEST_F(CarmenLog, KeepsTheOrderOfTheFileWhereStampsStepBack) {
    const auto frames = read(flaser("1 2 3", 0.0, "10.0") + flaser("1 2 3", 0.1, "9.5") + flaser("1 2 3", 0.2, "11.0"));
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[1].scan.stamp_ns, 9'500'000'000);
    EXPECT_DOUBLE_EQ(frames[1].odom_from_robot.x_m, 0.1);
    EXPECT_DOUBLE_EQ(frames[2].odom_from_robot.x_m, 0.2);
}

TEST_F(CarmenLog, IsTheSameCompressed) {
    const std::string text = offset_param + flaser("1 2 81.83", 0.0, "10.0") + flaser("3 4 5", 0.1, "10.2");
    for (const auto pack : {test::plain, test::gzip, test::bzip2}) {
        const auto frames = read(pack(text));
        ASSERT_EQ(frames.size(), 2U);
        EXPECT_EQ(frames[0].robot_from_laser, (Pose2{0.25, 0.0, 0.0}));
        EXPECT_TRUE(std::isinf(frames[0].scan.ranges_m[2]));
        EXPECT_EQ(frames[1].scan.ranges_m, (std::vector<float>{3, 4, 5}));
    }
    EXPECT_TRUE(problems_.empty());
}

TEST_F(CarmenLog, ReadingsFromAStatedMaximumOnAreNoReturn) {
    const auto frames = read("PARAM robot_front_laser_max 5.0 host 0\n" + flaser("0 4.99 5.0", 0.0, "1.0"));
    EXPECT_TRUE(std::isnan(frames[0].scan.ranges_m[0]));
    EXPECT_EQ(frames[0].scan.ranges_m[1], 4.99F);
    EXPECT_EQ(frames[0].scan.ranges_m[2], LaserScan::no_return);
    EXPECT_DOUBLE_EQ(frames[0].scan.range_max_m, 5.0);
}

TEST_F(CarmenLog, ARepeatedLargestReadingIsNoReturnFromTheFirstFrameOn) {
    std::string text;
    for (int i = 0; i < 20; ++i) {
        text += flaser("1 2 8.191", 0.1 * i, std::to_string(i) + ".0");
    }
    const auto frames = read(text);
    ASSERT_EQ(frames.size(), 20U);
    EXPECT_EQ(frames[0].scan.ranges_m[2], LaserScan::no_return);
    EXPECT_NEAR(frames[0].scan.range_max_m, 8.191, 1e-6);
}

TEST_F(CarmenLog, TheReadingsThatMeanNoReturnAreSaidAndCanBeGiven) {
    std::string text = offset_param;
    for (int i = 0; i < 20; ++i) {
        text += flaser("1 8.187 8.191", 0.1 * i, std::to_string(i) + ".0");
    }
    const auto found = open(text);
    EXPECT_EQ(read(*found)[0].scan.ranges_m, (std::vector<float>{1.0F, LaserScan::no_return, LaserScan::no_return}));
    ASSERT_EQ(found->summary().assumptions.size(), 2U);
    EXPECT_NE(found->summary().assumptions[0].find("8.191 m (20 of 60 readings"), std::string::npos);
    LogOptions told;
    told.no_return_m = {8.191};
    EXPECT_EQ(read(*open(text, told))[0].scan.ranges_m, (std::vector<float>{1.0F, 8.187F, LaserScan::no_return}));
    told.no_return_m = {8.2};
    const auto idle = open(text, told);
    ASSERT_EQ(idle->summary().assumptions.size(), 1U);
    EXPECT_NE(idle->summary().assumptions[0].find("--no-return 8.200 has no effect"), std::string::npos);
    told.no_return_m = {0.0};
    told.range_max_m = 5.0;
    EXPECT_EQ(read(*open(text, told))[0].scan.ranges_m,
              (std::vector<float>{1.0F, LaserScan::no_return, LaserScan::no_return}));
}

std::string moving(int i, double x) {
    const std::string range = std::to_string(1.0 + 0.1 * i);
    return flaser(range + " " + range + " 3", x, std::to_string(i) + ".0");
}

TEST_F(CarmenLog, OdometryThatNeverMovesIsNotBelieved) {
    std::string text = offset_param;
    for (int i = 0; i < 20; ++i) {
        text += moving(i, 5.0);
    }
    const auto stream = open(text);
    EXPECT_FALSE(stream->summary().has_odometry);
    EXPECT_EQ(read(*stream)[3].odom_from_robot, Pose2{});
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find("it never moves"), std::string::npos);
}

TEST_F(CarmenLog, OdometryThatStartsAgainAtZeroGoesOnAndCanBeLeftOut) {
    std::string text = offset_param;
    for (int i = 0; i < 60; ++i) {
        text += moving(i, 0.1 * (i < 40 ? i : i - 40));
    }
    EXPECT_NEAR(read(text)[50].odom_from_robot.x_m, 4.9, 1e-6);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find(":42: the odometry jumps by 3.90 m"), std::string::npos);
    LogOptions options;
    options.with_odometry = false;
    const auto stream = open(text, options);
    EXPECT_FALSE(stream->summary().has_odometry);
    EXPECT_EQ(read(*stream)[50].odom_from_robot, Pose2{});
}

TEST_F(CarmenLog, JumpsOfOdometryThatIsNotUsedAreNotSaid) {
    std::string text = offset_param;
    for (int i = 0; i < 60; ++i) {
        text += moving(i, 0.1 * (i < 40 ? i : i - 40));
    }
    LogOptions options;
    options.with_odometry = false;
    read(*open(text, options));
    EXPECT_TRUE(problems_.empty());
}

Pose2 pose_in_room(double t_s) {
    return {2.5 * std::sin(0.15 * t_s), 0.5 * std::sin(0.4 * t_s),
            0.5 * std::sin(0.7 * t_s) + 0.3 * std::sin(0.3 * t_s)};
}

/// A minute's drive in a room with scans at 5 Hz, in whose lines the odometry of `late_s` ago is, in such units.
std::string drive_in_room(double late_s, double per_metre = 1.0, double per_radian = 1.0) {
    RandomStream random({3});
    std::string text = "PARAM robot_frontlaser_offset 0 host 0\n";
    for (int i = 0; i < 300; ++i) {
        const double t_s = 0.2 * i;
        const LaserScan scan = test::room_scan(pose_in_room(t_s), t_s, random);
        text += "FLASER 181";
        for (std::size_t beam = 90; beam <= 270; ++beam) {
            text += " " + fixed_text(scan.ranges_m.at(beam), 3);
        }
        const Pose2 odom = pose_in_room(t_s - late_s);
        text += " 0 0 0";
        for (const double number : {per_metre * odom.x_m, per_metre * odom.y_m, per_radian * odom.theta_rad}) {
            text += " " + fixed_text(number, 6);
        }
        text += " " + fixed_text(100.0 + t_s, 3) + " host " + fixed_text(t_s, 3) + "\n";
    }
    return text;
}

double largest_error_m(const std::vector<SensorFrame>& frames) {
    double largest_m = 0.0;
    for (std::size_t i = 5; i + 5 < frames.size(); ++i) {
        largest_m =
            std::max(largest_m, distance_m(frames[i].odom_from_robot, pose_in_room(0.2 * static_cast<double>(i))));
    }
    return largest_m;
}

TEST_F(CarmenLog, TheDelayOfTheOdometryIsSaidAndTakenOffIfAskedFor) {
    for (const double late_s : {-0.15, 0.12}) {
        const std::string text = drive_in_room(late_s);
        const auto stream = open(text);
        const auto frames = read(*stream);
        ASSERT_TRUE(stream->summary().odom_delay) << late_s;
        EXPECT_NEAR(stream->summary().odom_delay->late_s, late_s, 0.02);
        EXPECT_EQ(stream->summary().odom_delay_removed_s, 0.0);
        ASSERT_EQ(stream->summary().assumptions.size(), 1U);
        EXPECT_NE(stream->summary().assumptions[0].find("--odom-delay"), std::string::npos);
        EXPECT_GT(largest_error_m(frames), 0.03);
        LogOptions options;
        options.odom_delay_s = late_s;
        const auto mended = open(text, options);
        const auto mended_frames = read(*mended);
        ASSERT_EQ(mended_frames.size(), 300U);
        EXPECT_LT(largest_error_m(mended_frames), 0.01);
        EXPECT_TRUE(mended->summary().assumptions.empty());
        EXPECT_EQ(mended->summary().odom_delay_removed_s, late_s);
    }
    const auto stream = open(drive_in_room(0.0));
    EXPECT_TRUE(stream->summary().odom_delay);
    EXPECT_TRUE(stream->summary().assumptions.empty());
    EXPECT_TRUE(problems_.empty());
}

TEST_F(CarmenLog, OdometryInAnotherUnitIsNotUsed) {
    const auto in_centimetres = open(drive_in_room(0.0, 100.0));
    EXPECT_FALSE(in_centimetres->summary().has_odometry);
    read(*in_centimetres);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find("as if it were in centimetres"), std::string::npos);
    problems_.clear();
    EXPECT_FALSE(open(drive_in_room(0.0, 1.0, 180.0 / std::numbers::pi))->summary().has_odometry);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find("only if it is in degrees"), std::string::npos);
}

TEST_F(CarmenLog, RangesInAnotherUnitAreSaid) {
    std::string text = offset_param;
    for (int i = 0; i < 3; ++i) {
        text += "FLASER 12 79.5 115 120 131 142 155 166 177 188 199 207 218 0 0 0 0 0 0 " + std::to_string(i) +
                ".0 host 0\n";
    }
    open(text);
    ASSERT_FALSE(problems_.empty());
    EXPECT_NE(problems_[0].what.find("half of the ranges are beyond 100 (up to 218)"), std::string::npos);
}

TEST_F(CarmenLog, WithoutAnOffsetTheLaserIsAssumedAtTheOrigin) {
    const auto stream = open(flaser("1 2 3", 0.0, "1.0"));
    EXPECT_EQ(stream->next()->robot_from_laser, Pose2{});
    EXPECT_EQ(stream->summary().assumptions.size(), 1U);
    EXPECT_EQ(stream->summary().problems, 0U);
}

TEST_F(CarmenLog, AGivenLaserPoseWins) {
    const Pose2 mounting{0.1, 0.2, 0.3};
    const auto stream = open(offset_param + flaser("1 2 3", 0.0, "1.0"), test::topics("", "", "", mounting));
    EXPECT_EQ(stream->next()->robot_from_laser, mounting);
}

TEST_F(CarmenLog, SkipsDamagedLinesAndCountsThem) {
    const auto stream = open(flaser("1 2 3", 0.0, "1.0") + "FLASER 3 1 2\nODOM x\n" + flaser("1 2 3", 0.0, "2.0"));
    EXPECT_EQ(read(*stream).size(), 2U);
    EXPECT_EQ(stream->summary().problems, 1U);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find(":2:"), std::string::npos);
}

TEST_F(CarmenLog, WithoutAnyReadableLineSaysWhatIsWrongWithTheFirst) {
    try {
        open("FLASER 3 1,5 2,5 3,5 0 0 0 0 0 0 1.0 host 0\n");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what())
                      .find(":1: skipped a damaged FLASER line: word 3 is '1,5', expected a range in "
                            "metres with a decimal point"),
                  std::string::npos)
            << error.what();
    }
}

TEST_F(CarmenLog, UsesOneKindOfScanAndTheOneAskedFor) {
    const std::string robotlaser = "ROBOTLASER1 0 -1 2 1 50 0 0 3 1 2 50 0 1.5 0 0 1 0 0 0 0 0 0 0 3.0 host 0\n";
    const std::string text = flaser("1 2 3", 0.0, "1.0") + robotlaser + flaser("1 2 3", 0.0, "2.0");
    EXPECT_EQ(read(text).size(), 2U);
    const auto frames = read(*open(text, test::topics("ROBOTLASER1")));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].robot_from_laser, (Pose2{0.5, 0.0, 0.0}));
    EXPECT_EQ(frames[0].scan.ranges_m[2], LaserScan::no_return);
}

TEST_F(CarmenLog, RefusesOptionsItCannotMeet) {
    const std::string text = flaser("1 2 3", 0.0, "1.0");
    EXPECT_THROW(open(text, test::topics("/scan")), UsageError);
    EXPECT_THROW(open(text, test::topics("", "/odom")), UsageError);
    EXPECT_THROW(open(text, test::topics("", "", "/gt")), UsageError);
    LogOptions of_robot;
    of_robot.robot = "robot1";
    EXPECT_THROW(open(text, of_robot), UsageError);
    LogOptions with_imu;
    with_imu.imu_topic = "/imu";
    EXPECT_THROW(open(text, with_imu), UsageError);
    LogOptions with_path;
    with_path.odom_path = 2;
    EXPECT_THROW(open(text, with_path), UsageError);
}

TEST_F(CarmenLog, SaysWhichOptionsHaveNoEffect) {
    LogOptions options;
    options.height = HeightBand{0.1, 1.0};
    const auto stream = open(offset_param + flaser("1 2 3", 0.0, "1.0"), options);
    ASSERT_EQ(stream->summary().assumptions.size(), 1U);
    EXPECT_NE(stream->summary().assumptions[0].find("--height has no effect"), std::string::npos);
}

TEST_F(CarmenLog, WithoutScansIsAnErrorThatSaysWhatThereIs) {
    EXPECT_THROW(open("ODOM 0 0 0 0 0 0 1.0 host 0\n")->next(), Error);
    try {
        open(flaser("1 2 3", 0.0, "1.0"), test::topics("ROBOTLASER1"))->next();
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("FLASER"), std::string::npos);
    }
}

TEST_F(CarmenLog, CutOffAnywhereNeverCrashes) {
    const std::string text = offset_param + flaser("1 2 3", 0.0, "1.0") + flaser("1 2 3", 0.0, "2.0");
    write_file(folder_ / "cut", text);
    for (std::size_t length = text.size(); length-- > 0;) {
        std::filesystem::resize_file(folder_ / "cut", length);
        try {
            EXPECT_LE(read(*open_log(folder_ / "cut", {}, {})).size(), 2U);
        } catch (const Error&) {
            EXPECT_LT(length, text.rfind("FLASER")) << "the first scan was lost";
        }
    }
}

TEST_F(CarmenLog, OtherFilesAreRefusedInOneLine) {
    for (const std::string content : {"", "hello\n",
                                      "\x7f"
                                      "ELF"}) {
        EXPECT_THROW(open(content), Error);
    }
}

}  // namespace
}  // namespace ddtool
