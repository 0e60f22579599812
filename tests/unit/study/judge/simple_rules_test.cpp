#include "study/judge/simple_rules.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "known_dataset.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {
namespace {

using dataset::LabelRule;
using dataset::Split;
using ddtool::test::KnownDataset;

TEST(FittedRules, ThoseThatSeeTheStepSwarmFindWhatIsInIt) {
    const KnownDataset known;
    const auto rules = fitted_rules(known.data(), LabelRule::fisher, Split::paper);
    EXPECT_EQ(rules.back().name, "logistic regression");
    for (const Detector& rule : rules) {
        EXPECT_FALSE(rule.is_model());
        if (rule.swarm == "step" || rule.swarm == "both") {
            EXPECT_EQ(evaluate(known.data(), rule, {.split = Split::paper}).performance.confusion.accuracy(), 1.0)
                << rule.name;
        }
    }
}

TEST(FittedRules, LookAtThePartTrainAlone) {
    const KnownDataset known;
    const KnownDataset other(dataset::Part::test);
    const auto rules = fitted_rules(known.data(), LabelRule::fisher, Split::held_out);
    const auto same = fitted_rules(other.data(), LabelRule::fisher, Split::held_out);
    ASSERT_EQ(rules.size(), same.size());
    for (std::size_t rule = 0; rule < rules.size(); ++rule) {
        EXPECT_EQ(rules[rule].decision, same[rule].decision);
        EXPECT_EQ(rules[rule].threshold, same[rule].threshold);
    }
    EXPECT_EQ(evaluate(other.data(), same.back(), {}).performance.confusion.accuracy(), 0.0);
}

TEST(FittedRules, TurnWhereTrainingSaysSo) {
    const KnownDataset turned(dataset::Part::train);
    const auto rules = fitted_rules(turned.data(), LabelRule::fisher, Split::held_out);
    const auto spread = std::find_if(
        rules.begin(), rules.end(), [](const Detector& rule) { return rule.name == "spread" && rule.swarm == "step"; });
    EXPECT_THAT(spread->decision, testing::StartsWith("below "));
    EXPECT_EQ(evaluate(turned.data(), *spread, {}).performance.auc, 0.0);
}

TEST(FittedRules, WithoutLabelsHaveScoresAndNoThresholds) {
    const KnownDataset known;
    const auto rules = fitted_rules(known.data(), LabelRule::dispersion, Split::paper);
    EXPECT_NE(rules.back().name, "logistic regression");
    for (const Detector& rule : rules) {
        EXPECT_TRUE(std::isnan(rule.threshold)) << rule.name;
        const Evaluation evaluation = evaluate(known.data(), rule, {.label = LabelRule::dispersion});
        EXPECT_EQ(evaluation.performance.confusion.count(), 0U);
        ASSERT_EQ(evaluation.physics.size(), 2U) << "all samples, since none has the label";
    }
}

}  // namespace
}  // namespace ddtool::judge
