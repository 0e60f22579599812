#include "scores/statistics.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

std::vector<double> normal_sample(std::size_t count, std::uint64_t seed, double shift = 0.0) {
    RandomStream random{seed};
    std::vector<double> values(count);
    std::generate(values.begin(), values.end(), [&] { return shift + random.normal(); });
    return values;
}

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
    const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
    EXPECT_DOUBLE_EQ(quantile(values, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(median(values), 2.5);
    EXPECT_DOUBLE_EQ(quantile(values, 1.0), 4.0);
    EXPECT_DOUBLE_EQ(median(std::vector{7.0}), 7.0);
    EXPECT_TRUE(std::isnan(median({})));
}

TEST(Quantile, GivesFailedRunsTheirPlace) {
    EXPECT_DOUBLE_EQ(median(std::vector{inf, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median(std::vector{inf, inf, inf, 1.0}), inf);
    EXPECT_EQ(median(std::vector{inf, 1.0}), inf);
}

TEST(MedianInterval, TakesTheTabulatedOrderStatistics) {
    // According to tables of the sign test at 95 %: the 2nd and 9th of 10 values, the 6th and 15th of 20.
    std::vector<double> values(20);
    std::generate(values.begin(), values.end(), [n = 20.0]() mutable { return n--; });
    const MedianInterval of_twenty = median_interval(values);
    EXPECT_EQ(of_twenty.low, 6.0);
    EXPECT_EQ(of_twenty.high, 15.0);
    EXPECT_NEAR(of_twenty.coverage, 0.9586, 5e-5);
    const MedianInterval of_ten = median_interval(std::span(values).last(10));
    EXPECT_EQ(of_ten.low, 2.0);
    EXPECT_EQ(of_ten.high, 9.0);
    EXPECT_NEAR(of_ten.coverage, 0.9785, 5e-5);
}

TEST(MedianInterval, SaysWhenFewValuesCoverTooLittle) {
    const MedianInterval of_five = median_interval(std::vector{3.0, 1.0, 2.0, 5.0, 4.0});
    EXPECT_EQ(of_five.low, 1.0);
    EXPECT_EQ(of_five.high, 5.0);
    EXPECT_DOUBLE_EQ(of_five.coverage, 0.9375);
    EXPECT_EQ(median_interval(std::vector{3.0}).coverage, 0.0);
}

TEST(MedianInterval, CoversTheTrueMedianAsOftenAsItSays) {
    constexpr std::size_t trials = 2000;
    std::size_t covered = 0;
    double coverage = 0.0;
    for (std::size_t trial = 0; trial < trials; ++trial) {
        const MedianInterval interval = median_interval(normal_sample(15, trial));
        covered += interval.low <= 0.0 && 0.0 <= interval.high ? 1 : 0;
        coverage = interval.coverage;
    }
    EXPECT_NEAR(static_cast<double>(covered) / trials, coverage, 0.02);
}

TEST(SignedRank, ReachesItsSmallestPWhenAllDifferOneWay) {
    for (const std::size_t count : {1U, 5U, 6U, 10U}) {
        const std::vector<double> first = normal_sample(count, 1);
        std::vector<double> second = first;
        for (std::size_t i = 0; i < count; ++i) {
            second[i] += 1.0 + static_cast<double>(i);
        }
        EXPECT_NEAR(wilcoxon_signed_rank(first, second).p_value, std::pow(2.0, 1.0 - static_cast<double>(count)),
                    1e-12);
    }
}

TEST(SignedRank, AgreesWithTheTabulatedDistribution) {
    // The ranks are 1..8, and the negative differences have the ranks 1 and 3, so their rank sum is 4. Seven subsets of
    // 1..8 have a sum of at most 4: {}, {1}, {2}, {3}, {4}, {1, 2}, {1, 3}.
    const std::vector<double> zeros(8, 0.0);
    const std::vector<double> differences{-1.0, 2.0, -3.0, 4.0, 5.0, 6.0, 7.0, 8.0};
    const PairedTest test = wilcoxon_signed_rank(zeros, differences);
    EXPECT_NEAR(test.p_value, 2.0 * 7.0 / 256.0, 1e-12);
    EXPECT_DOUBLE_EQ(test.median_difference, 4.5);
    EXPECT_EQ(test.differing_pairs, 8U);
}

TEST(SignedRank, SharesTiedRanks) {
    // The ranks are 1.5, 1.5 and 3, and the negative difference has 1.5. Of the eight subsets, three have a sum of at
    // most 1.5: {} and twice {1.5}.
    EXPECT_NEAR(wilcoxon_signed_rank(std::vector(3, 0.0), std::vector{-1.0, 1.0, 2.0}).p_value, 2.0 * 3.0 / 8.0, 1e-12);
}

TEST(SignedRank, SeesNoDifferenceBetweenEquals) {
    const std::vector<double> values{1.0, 2.0, inf};
    const PairedTest test = wilcoxon_signed_rank(values, values);
    EXPECT_EQ(test.p_value, 1.0);
    EXPECT_EQ(test.differing_pairs, 0U);
    EXPECT_EQ(test.median_difference, 0.0);
}

TEST(SignedRank, IsTheSameBothWaysRound) {
    const std::vector<double> first = normal_sample(12, 2);
    const std::vector<double> second = normal_sample(12, 3, 0.5);
    const PairedTest there = wilcoxon_signed_rank(first, second);
    const PairedTest back = wilcoxon_signed_rank(second, first);
    EXPECT_LT(there.p_value, 1.0);
    EXPECT_DOUBLE_EQ(there.p_value, back.p_value);
    EXPECT_DOUBLE_EQ(there.median_difference, -back.median_difference);
}

TEST(SignedRank, RaisesFewFalseAlarms) {
    constexpr std::size_t trials = 2000;
    std::size_t alarms = 0;
    for (std::size_t trial = 0; trial < trials; ++trial) {
        const auto test = wilcoxon_signed_rank(normal_sample(10, 2 * trial), normal_sample(10, 2 * trial + 1));
        alarms += test.p_value <= 0.05 ? 1 : 0;
    }
    EXPECT_LT(static_cast<double>(alarms) / trials, 0.06);
    EXPECT_GT(static_cast<double>(alarms) / trials, 0.03);
}

TEST(MeanAndSd, ShiftsAndScalesWithTheValues) {
    const MeanAndSd plain = mean_and_sd(std::vector{1.0, 2.0, 4.0, 5.0});
    EXPECT_DOUBLE_EQ(plain.mean, 3.0);
    EXPECT_DOUBLE_EQ(plain.sd, std::sqrt(10.0 / 3.0));
    const MeanAndSd changed = mean_and_sd(std::vector{-2.0, -4.0, -8.0, -10.0});
    EXPECT_DOUBLE_EQ(changed.mean, -2.0 * plain.mean);
    EXPECT_DOUBLE_EQ(changed.sd, 2.0 * plain.sd);
    EXPECT_TRUE(std::isnan(mean_and_sd(std::vector{7.0}).sd));
    EXPECT_TRUE(std::isnan(mean_and_sd({}).mean));
}

}  // namespace
}  // namespace ddtool
