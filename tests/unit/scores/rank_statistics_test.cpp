#include "scores/rank_statistics.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;

struct Scored {
    std::vector<double> scores;
    std::vector<bool> positive;
};

/// Random scores with few distinct values, so that there are ties.
Scored drawn(std::uint64_t seed, std::size_t count) {
    RandomStream random({seed});
    Scored scored;
    for (std::size_t i = 0; i < count; ++i) {
        scored.positive.push_back(random.index(3) == 0);
        scored.scores.push_back(static_cast<double>(random.index(6) + (scored.positive.back() ? 1U : 0U)));
    }
    return scored;
}

/// The AUC by its definition, over all pairs of a positive and a negative sample.
double auc_by_pairs(const Scored& scored) {
    double won = 0.0;
    double pairs = 0.0;
    for (std::size_t i = 0; i < scored.scores.size(); ++i) {
        for (std::size_t j = 0; j < scored.scores.size(); ++j) {
            if (scored.positive[i] && !scored.positive[j]) {
                pairs += 1.0;
                won += scored.scores[i] > scored.scores[j] ? 1.0 : scored.scores[i] == scored.scores[j] ? 0.5 : 0.0;
            }
        }
    }
    return won / pairs;
}

TEST(DoubledRanks, TiesShareTheirMean) {
    EXPECT_THAT(doubled_ranks(std::vector{5.0, 1.0, 5.0, 9.0}), ElementsAre(5U, 2U, 5U, 8U));
}

TEST(RocAuc, IsTheShareOfPairsInOrder) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Scored scored = drawn(seed, 40);
        EXPECT_NEAR(roc_auc(scored.scores, scored.positive), auc_by_pairs(scored), 1e-12) << seed;
    }
}

TEST(RocAuc, TurnsRoundWithTheScoresAndWithTheClasses) {
    Scored scored = drawn(3, 50);
    const double auc = roc_auc(scored.scores, scored.positive);
    for (double& score : scored.scores) {
        score = -std::exp(score);  // any decreasing function
    }
    EXPECT_NEAR(roc_auc(scored.scores, scored.positive), 1.0 - auc, 1e-12);
    scored.positive.flip();
    EXPECT_NEAR(roc_auc(scored.scores, scored.positive), auc, 1e-12);
}

TEST(RocAuc, InfiniteScoresHaveTheirPlace) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(roc_auc(std::vector{infinite, 1.0, infinite}, {true, false, true}), 1.0);
    EXPECT_EQ(roc_auc(std::vector{infinite, infinite}, {true, false}), 0.5);
}

TEST(RocAuc, NeedsBothClassesAndIgnoresNaN) {
    EXPECT_TRUE(std::isnan(roc_auc(std::vector{1.0, 2.0}, {true, true})));
    EXPECT_EQ(roc_auc(std::vector{1.0, std::nan(""), 2.0}, {false, false, true}), 1.0);
}

TEST(RankCorrelation, IsOneForAnyRisingFunction) {
    std::vector<double> x;
    std::vector<double> y;
    RandomStream random({7});
    for (int i = 0; i < 30; ++i) {
        x.push_back(random.uniform(-3.0, 3.0));
        y.push_back(std::exp(x.back()));
    }
    EXPECT_NEAR(rank_correlation(x, y), 1.0, 1e-12);
    std::reverse(y.begin(), y.end());
    std::reverse(x.begin(), x.end());
    EXPECT_NEAR(rank_correlation(x, y), 1.0, 1e-12);
    for (double& value : y) {
        value = -value;
    }
    EXPECT_NEAR(rank_correlation(x, y), -1.0, 1e-12);
}

TEST(RankCorrelation, MatchesSpearmansFormulaWithoutTies) {
    const std::vector<double> x{1.0, 2.0, 3.0, 4.0, 5.0};
    const std::vector<double> y{2.0, 1.0, 4.0, 3.0, 5.0};
    EXPECT_NEAR(rank_correlation(x, y), 1.0 - 6.0 * 4.0 / (5.0 * 24.0), 1e-12);
}

TEST(RankCorrelation, IsMissingWhereOneSideIsConstant) {
    EXPECT_TRUE(std::isnan(rank_correlation(std::vector{1.0, 1.0}, std::vector{1.0, 2.0})));
    EXPECT_TRUE(std::isnan(rank_correlation({}, {})));
}

TEST(RocCurve, RisesFromCornerToCornerAndHasTheAucBelowIt) {
    const Scored scored = drawn(11, 60);
    const std::vector<RocPoint> points = roc_curve(scored.scores, scored.positive);
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_GE(points[i].false_positive_rate, points[i - 1].false_positive_rate);
        EXPECT_GE(points[i].true_positive_rate, points[i - 1].true_positive_rate);
        area += (points[i].false_positive_rate - points[i - 1].false_positive_rate) *
                (points[i].true_positive_rate + points[i - 1].true_positive_rate) / 2.0;
    }
    EXPECT_EQ(points.front().true_positive_rate, 0.0);
    EXPECT_EQ(points.back().false_positive_rate, 1.0);
    EXPECT_NEAR(area, roc_auc(scored.scores, scored.positive), 1e-12);
    EXPECT_TRUE(roc_curve(scored.scores, std::vector<bool>(scored.scores.size(), true)).empty());
}

}  // namespace
}  // namespace ddtool
