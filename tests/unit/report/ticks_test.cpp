#include "report/ticks.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace ddtool::report {
namespace {

struct TickRange {
    double low;
    double high;
};

class NiceTicks : public testing::TestWithParam<TickRange> {};

TEST_P(NiceTicks, LieInTheRangeAtEvenNiceDistances) {
    const auto [low, high] = GetParam();
    const Ticks ticks = nice_ticks(low, high, 6);
    ASSERT_GE(ticks.places.size(), 2U);
    const double distance = ticks.places[1] - ticks.places[0];
    const double digit = distance / std::pow(10.0, std::floor(std::log10(distance) + 1e-6));
    EXPECT_THAT(digit, testing::AnyOf(testing::DoubleNear(1, 1e-4), testing::DoubleNear(2, 1e-4),
                                      testing::DoubleNear(5, 1e-4)));
    for (std::size_t i = 0; i < ticks.places.size(); ++i) {
        EXPECT_NEAR(ticks.places[i], ticks.places[0] + static_cast<double>(i) * distance, 1e-6 * distance);
    }
    EXPECT_GE(ticks.places.front(), low - 1e-6 * distance);
    EXPECT_LE(ticks.places.back(), high + 1e-6 * distance);
}

TEST_P(NiceTicks, AreAboutAsManyAsWanted) {
    const auto [low, high] = GetParam();
    for (const std::size_t wanted : {4U, 6U, 10U}) {
        const std::size_t count = nice_ticks(low, high, wanted).places.size();
        EXPECT_GE(2 * count, wanted - 1);
        EXPECT_LE(count, wanted + 1);
    }
}

TEST_P(NiceTicks, HaveTextsThatDiffer) {
    const auto [low, high] = GetParam();
    const Ticks ticks = nice_ticks(low, high, 6);
    std::set<std::string> texts;
    for (const double place : ticks.places) {
        texts.insert(tick_text(place, ticks.decimals));
    }
    EXPECT_EQ(texts.size(), ticks.places.size());
}

INSTANTIATE_TEST_SUITE_P(Ranges, NiceTicks,
                         testing::Values(TickRange{0, 1}, TickRange{-3.7, 12.2}, TickRange{0, 0.15},
                                         TickRange{1e-5, 7e-5}, TickRange{-1000, -3}, TickRange{2e6, 9e6},
                                         TickRange{99.98, 100.01}));

TEST(TickText, HasNoMinusZero) {
    const Ticks ticks = nice_ticks(-1.0, 1.0, 4);
    EXPECT_THAT(ticks.places, testing::Contains(0.0));
    for (const double place : ticks.places) {
        EXPECT_NE(tick_text(place, ticks.decimals), "-0.0");
    }
}

}  // namespace
}  // namespace ddtool::report
