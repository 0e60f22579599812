#include "scores/confusion.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

struct Drawn {
    std::vector<double> scores;
    std::vector<bool> positive;
};

Drawn drawn_decisions(std::size_t count) {
    RandomStream random({7});
    Drawn samples;
    for (std::size_t i = 0; i < count; ++i) {
        samples.positive.push_back(random.index(3) == 0);
        samples.scores.push_back(random.normal() + (samples.positive.back() ? 1.0 : 0.0));
    }
    return samples;
}

TEST(Confusion, CountsEveryDecisionInItsPlace) {
    const std::vector<double> scores{0.9, 0.8, 0.2, 0.1, 0.5};
    const Confusion confusion = confusion_of(scores, {true, false, true, false, true}, 0.5);
    EXPECT_EQ(confusion, (Confusion{1, 1, 2, 1}));
    EXPECT_DOUBLE_EQ(confusion.accuracy(), 0.4);
    EXPECT_DOUBLE_EQ(confusion.precision(), 0.5);
    EXPECT_DOUBLE_EQ(confusion.recall(), 1.0 / 3.0);
}

TEST(Confusion, F1IsTheHarmonicMeanOfPrecisionAndRecall) {
    const Drawn samples = drawn_decisions(200);
    for (const double threshold : {-1.0, 0.0, 0.7, 2.0}) {
        const Confusion confusion = confusion_of(samples.scores, samples.positive, threshold);
        EXPECT_EQ(confusion.count(), 200U);
        EXPECT_NEAR(confusion.f1(), 2.0 / (1.0 / confusion.precision() + 1.0 / confusion.recall()), 1e-12);
    }
}

TEST(Confusion, TurnedRoundSwapsTheClasses) {
    const Drawn samples = drawn_decisions(200);
    std::vector<double> turned;
    std::vector<bool> others;
    for (std::size_t i = 0; i < samples.scores.size(); ++i) {
        turned.push_back(-samples.scores[i]);
        others.push_back(!samples.positive[i]);
    }
    const Confusion one = confusion_of(samples.scores, samples.positive, 0.3);
    const Confusion other = confusion_of(turned, others, -0.3);
    EXPECT_EQ(other, (Confusion{one.true_negatives, one.false_negatives, one.false_positives, one.true_positives}));
}

TEST(Confusion, NothingToDivideByIsNan) {
    const Confusion confusion = confusion_of(std::vector{std::numeric_limits<double>::quiet_NaN()}, {false}, 0.0);
    EXPECT_EQ(confusion.accuracy(), 1.0);
    EXPECT_TRUE(std::isnan(confusion.precision()));
    EXPECT_TRUE(std::isnan(confusion.recall()));
    EXPECT_TRUE(std::isnan(confusion.f1()));
    EXPECT_TRUE(std::isnan(Confusion{}.accuracy()));
}

}  // namespace
}  // namespace ddtool
