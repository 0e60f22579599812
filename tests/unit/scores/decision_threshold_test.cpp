#include "scores/decision_threshold.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

struct ScoredLabels {
    std::vector<double> scores;
    std::vector<bool> positive;
};

/// Random scores with few distinct values, so that there are ties. Positives score higher by `gap`, or lower if it is
/// negative.
ScoredLabels drawn_scores(std::uint64_t seed, double gap) {
    RandomStream random({seed});
    ScoredLabels scored;
    for (std::size_t i = 0; i < 50; ++i) {
        scored.positive.push_back(random.index(2) == 0);
        scored.scores.push_back(std::round(2.0 * random.normal() + (scored.positive.back() ? gap : 0.0)));
    }
    return scored;
}

std::size_t right_by(const DecisionThreshold& threshold, const ScoredLabels& scored) {
    std::size_t right = 0;
    for (std::size_t i = 0; i < scored.scores.size(); ++i) {
        const bool above = scored.scores[i] > threshold.value;
        right += (above == threshold.positive_above) == scored.positive[i] ? 1U : 0U;
    }
    return right;
}

TEST(MostAccurateThreshold, NoOtherCutIsRightMoreOften) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const ScoredLabels scored = drawn_scores(seed, seed % 2 == 0 ? 2.0 : -2.0);
        const DecisionThreshold best = most_accurate_threshold(scored.scores, scored.positive);
        std::size_t most = 0;
        for (double value = -12.5; value < 12.0; value += 1.0) {
            most = std::max({most, right_by({value, true}, scored), right_by({value, false}, scored)});
        }
        EXPECT_EQ(right_by(best, scored), most) << seed;
    }
}

TEST(MostAccurateThreshold, TurnedScoresTurnTheSide) {
    ScoredLabels scored = drawn_scores(3, 4.0);
    const std::size_t right = right_by(most_accurate_threshold(scored.scores, scored.positive), scored);
    std::transform(scored.scores.begin(), scored.scores.end(), scored.scores.begin(), std::negate<>());
    const DecisionThreshold turned = most_accurate_threshold(scored.scores, scored.positive);
    EXPECT_FALSE(turned.positive_above);
    EXPECT_EQ(right_by(turned, scored), right);
}

TEST(MostAccurateThreshold, OneClassIsDecidedWithoutLooking) {
    const std::vector<double> scores{1.0, 2.0};
    const DecisionThreshold all = most_accurate_threshold(scores, {true, true});
    EXPECT_TRUE(std::isinf(all.value));
    EXPECT_EQ(right_by(all, {scores, {true, true}}), 2U);
    EXPECT_EQ(right_by(most_accurate_threshold(scores, {false, false}), {scores, {false, false}}), 2U);
}

TEST(MostAccurateThreshold, LiesBetweenTheClassesThatScoresPart) {
    const DecisionThreshold cut = most_accurate_threshold(std::vector{4.0, 1.0, 2.0, 8.0}, {true, false, false, true});
    EXPECT_EQ(cut.value, 3.0);
    EXPECT_TRUE(cut.positive_above);
}

}  // namespace
}  // namespace ddtool
