#include "logs/stream/no_return.hpp"

#include <gtest/gtest.h>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

std::vector<float> echoes(double low_m, double high_m) {
    RandomStream random({3});
    std::vector<float> ranges(5000);
    for (float& range : ranges) {
        range = static_cast<float>(random.uniform(low_m, high_m));
    }
    return ranges;
}

class NoReturnCode : public testing::TestWithParam<float> {};

TEST_P(NoReturnCode, IsFoundAmongEchoes) {
    std::vector<float> ranges = echoes(0.2, 0.9 * GetParam());
    ranges.insert(ranges.begin() + 100, 700, GetParam());
    EXPECT_EQ(find_no_return_code(ranges), GetParam());
}

// The SICK LMS in centimetre mode and in millimetre mode, and lidars with a short and with a long range.
INSTANTIATE_TEST_SUITE_P(Lidars, NoReturnCode, testing::Values(81.83F, 81.91F, 8.191F, 5.6F, 50.0F));

TEST(NoReturn, RareHigherCodesDoNotHideTheUsualOne) {
    std::vector<float> ranges = echoes(0.2, 7.0);
    ranges.insert(ranges.end(), 500, 8.183F);
    ranges.insert(ranges.end(), 3, 8.190F);
    EXPECT_EQ(find_no_return_code(ranges), 8.183F);
}

TEST(NoReturn, EchoesAloneHaveNone) {
    EXPECT_FALSE(find_no_return_code(echoes(0.2, 12.0)));
    EXPECT_FALSE(find_no_return_code({}));
}

TEST(NoReturn, AFarWallSeenAgainAndAgainIsNoCode) {
    std::vector<float> ranges = echoes(0.2, 5.0);
    for (int i = 0; i < 500; ++i) {
        ranges.push_back(20.00F + 0.01F * static_cast<float>(i % 5));
    }
    EXPECT_FALSE(find_no_return_code(ranges));
}

}  // namespace
}  // namespace ddtool
