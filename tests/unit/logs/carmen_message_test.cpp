#include "logs/messages/carmen_message.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace ddtool {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string flaser_words(std::size_t beams) {
    std::string words = " " + std::to_string(beams);
    for (std::size_t beam = 0; beam < beams; ++beam) {
        words += " 2.5";
    }
    return words + " 1.0 2.0 0.5 3.0 4.0 -0.5 976052857.337530 nohost 0.000246";
}

TEST(Flaser, CarriesItsOdometryAndExactTime) {
    const auto message = parse_flaser(flaser_words(3)).scan;
    ASSERT_TRUE(message);
    EXPECT_EQ(message->scan.stamp_ns, 976'052'857'337'530'000);
    EXPECT_EQ(message->odom_from_laser, (Pose2{1.0, 2.0, 0.5}));
    EXPECT_EQ(message->odom_from_robot, (Pose2{3.0, 4.0, -0.5}));
    EXPECT_EQ(message->scan.ranges_m, (std::vector<float>{2.5F, 2.5F, 2.5F}));
}

struct Fan {
    std::size_t beams;
    double first_degrees;
    double last_degrees;
};

class FlaserFan : public testing::TestWithParam<Fan> {};

TEST_P(FlaserFan, FollowsTheTableOfSickLasers) {
    const auto message = parse_flaser(flaser_words(GetParam().beams)).scan;
    ASSERT_TRUE(message);
    EXPECT_NEAR(message->scan.angle_rad(0), GetParam().first_degrees * degree, 1e-12);
    EXPECT_NEAR(message->scan.angle_rad(GetParam().beams - 1), GetParam().last_degrees * degree, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Counts, FlaserFan,
                         testing::Values(Fan{180, -90, 89}, Fan{181, -90, 90}, Fan{360, -90, 89.5}, Fan{361, -90, 90},
                                         Fan{400, -50, 49.75}, Fan{401, -50, 50}, Fan{91, -90, 90}, Fan{1, -90, -90}));

TEST(Flaser, IsRefusedWhereverItIsCutBeforeItsHost) {
    const std::string words = flaser_words(4);
    const std::size_t host = words.find("nohost");
    for (std::size_t length = 0; length <= host; ++length) {
        EXPECT_FALSE(parse_flaser(words.substr(0, length)).scan) << length;
    }
    EXPECT_TRUE(parse_flaser(words.substr(0, host + 1)).scan);
}

TEST(Flaser, RefusesCountsThatTheLineCannotHold) {
    for (const char* count : {"0", "-1", "2.5", "1e300", "99999999999", "nan"}) {
        EXPECT_FALSE(parse_flaser(std::string(count) + " 2.5 2.5 1 2 3 4 5 6 7.0 host 8.0").scan) << count;
    }
}

TEST(Flaser, RefusesPlacesThatCannotBe) {
    EXPECT_TRUE(parse_flaser("1 2.5 1 2 3 1e6 5 6 7.0 host 8.0").scan);
    EXPECT_FALSE(parse_flaser("1 2.5 1 2 3 1e300 5 6 7.0 host 8.0").scan);
}

TEST(Flaser, SaysWhichWordIsWrong) {
    EXPECT_EQ(parse_flaser("2 1,53 2.5 1 2 3 4 5 6 7.0 host 8.0").fault,
              "word 3 is '1,53', expected a range in metres with a decimal point");
    EXPECT_EQ(parse_flaser("2 1.5 2.5 nan 2 3 4 5 6 7.0 host 8.0").fault, "word 5 is 'nan', expected a number");
    EXPECT_EQ(parse_flaser("2 1.5 2.5 1 2").fault, "it ends before word 7, expected a number");
    EXPECT_EQ(parse_flaser("9 1.5 2.5").fault,
              "word 2 is '9', expected the number of the values that follow in the line");
    EXPECT_EQ(parse_flaser("0 1 2 3 4 5 6 7.0 host 8.0").fault, "it has 0 readings");
}

TEST(Flaser, ReadingsMayBeNoNumbers) {
    const auto message = parse_flaser("4 inf nan -inf 2.5 1 2 3 4 5 6 7.0 host 8.0").scan;
    ASSERT_TRUE(message);
    EXPECT_EQ(message->scan.ranges_m[0], LaserScan::no_return);
    EXPECT_TRUE(std::isnan(message->scan.ranges_m[1]));
    EXPECT_EQ(message->scan.ranges_m[3], 2.5F);
}

TEST(Robotlaser, StatesItsOwnFanRangeAndMounting) {
    const auto message =
        parse_robotlaser(
            " 0 -1.5 3.0 0.75 50.0 0.01 0 5 1 2 3 4 50 2 7 8  1.2 2.0 0 1.0 2.0 0  0 0 0.1 0.1 1e6 12.5 host 0.1")
            .scan;
    ASSERT_TRUE(message);
    EXPECT_EQ(message->scan.stamp_ns, 12'500'000'000);
    EXPECT_DOUBLE_EQ(message->scan.angle_min_rad, -1.5);
    EXPECT_DOUBLE_EQ(message->scan.angle_increment_rad, 0.75);
    EXPECT_DOUBLE_EQ(message->scan.range_max_m, 50.0);
    EXPECT_EQ(message->scan.ranges_m, (std::vector<float>{1, 2, 3, 4, 50}));
    EXPECT_EQ(message->odom_from_laser, (Pose2{1.2, 2.0, 0.0}));
    EXPECT_EQ(message->odom_from_robot, (Pose2{1.0, 2.0, 0.0}));
}

TEST(LooksLikeCarmen, NeedsALineThatBeginsWithAMessageName) {
    EXPECT_TRUE(looks_like_carmen("# comment\nPARAM robot_length 0.5 nohost 0\n"));
    EXPECT_TRUE(looks_like_carmen("FLASER 1 2.0"));
    EXPECT_FALSE(looks_like_carmen("1.0 2.0 FLASER \n"));
    EXPECT_FALSE(looks_like_carmen(""));
}

}  // namespace
}  // namespace ddtool
