#include "ddtool/base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace ddtool {
namespace {

constexpr int samples = 100'000;
/// Five standard errors of the mean of `samples` draws with unit variance. A right generator exceeds this one time in
/// two million.
const double bound = 5.0 / std::sqrt(samples);

TEST(RandomStream, SameKeysGiveTheSameStream) {
    RandomStream a({1, 2, 3});
    RandomStream b({1, 2, 3});
    for (int draw = 0; draw < 100; ++draw) {
        EXPECT_EQ(a(), b());
    }
}

TEST(RandomStream, EveryKeyListNamesAnotherStream) {
    const std::vector<RandomStream> streams{RandomStream({}),        RandomStream({0}),    RandomStream({0, 0}),
                                            RandomStream({0, 0, 0}), RandomStream({1}),    RandomStream({0, 1}),
                                            RandomStream({1, 0}),    RandomStream({1, 1}), RandomStream({2, 1}),
                                            RandomStream({1, 2})};
    std::set<std::uint64_t> firsts;
    for (RandomStream stream : streams) {
        firsts.insert(stream());
    }
    EXPECT_EQ(firsts.size(), streams.size());
}

TEST(RandomStream, UniformFillsItsRangeEvenly) {
    RandomStream random({11});
    std::array<int, 10> counts{};
    for (int draw = 0; draw < samples; ++draw) {
        const double value = random.uniform(-3.0, 7.0);
        ASSERT_GE(value, -3.0);
        ASSERT_LT(value, 7.0);
        ++counts.at(static_cast<std::size_t>(value + 3.0));
    }
    const double expected = samples / 10.0;
    for (const int count : counts) {  // the counts have a binomial distribution
        EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected * 0.9));
    }
}

TEST(RandomStream, NormalHasTheMomentsOfTheStandardNormal) {
    RandomStream random({12});
    std::array<double, 5> moments{};
    for (int draw = 0; draw < samples; ++draw) {
        const double value = random.normal();
        for (int power = 1; power <= 4; ++power) {
            moments.at(static_cast<std::size_t>(power)) += std::pow(value, power) / samples;
        }
    }
    // The variances of x, x^2, x^3 and x^4 for a normal x: Var(x^k) = E(x^2k) - E(x^k)^2 = 1, 2, 15, 96.
    EXPECT_NEAR(moments[1], 0.0, bound);
    EXPECT_NEAR(moments[2], 1.0, bound * std::sqrt(2.0));
    EXPECT_NEAR(moments[3], 0.0, bound * std::sqrt(15.0));
    EXPECT_NEAR(moments[4], 3.0, bound * std::sqrt(96.0));
}

TEST(RandomStream, NeighbouringStreamsAreUncorrelated) {
    double first_draws = 0.0;
    double along_streams = 0.0;
    for (std::uint64_t particle = 0; particle < samples; ++particle) {
        RandomStream stream({7, particle});
        RandomStream neighbour({7, particle + 1});
        const double value = stream.normal();
        first_draws += value * neighbour.normal() / samples;
        along_streams += value * stream.normal() / samples;
    }
    EXPECT_NEAR(first_draws, 0.0, bound);
    EXPECT_NEAR(along_streams, 0.0, bound);
}

TEST(RandomStream, IndexReachesEveryValueAndNoOther) {
    RandomStream random({13});
    std::set<std::uint64_t> seen;
    for (int draw = 0; draw < 1000; ++draw) {
        seen.insert(random.index(7));
    }
    EXPECT_EQ(seen, (std::set<std::uint64_t>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(random.index(1), 0U);
}

}  // namespace
}  // namespace ddtool
