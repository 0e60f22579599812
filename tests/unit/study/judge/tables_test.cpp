#include "study/judge/tables.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "known_dataset.hpp"
#include "study/judge/simple_rules.hpp"

namespace ddtool::judge {
namespace {

using ddtool::test::KnownDataset;

/// The evaluation of a network that is right for `right` of ten test samples.
Evaluation model(std::uint64_t seed, const std::string& family, std::uint64_t right) {
    Evaluation evaluation;
    evaluation.detector.name = "net";
    evaluation.detector.swarm = "step";
    evaluation.detector.label = "fisher";
    evaluation.detector.split = "paper";
    evaluation.detector.seed = seed;
    evaluation.detector.family = family;
    evaluation.performance.samples = 10;
    evaluation.performance.confusion = {.true_positives = right, .false_positives = 10 - right};
    return evaluation;
}

TEST(DetectorTable, NamesWhatWasTrainedOnWhatAndTestedOnWhat) {
    const Json rows = detector_table(std::vector{model(3, "a", 9)}, {}).json();
    EXPECT_EQ(rows[0].at("swarm"), "step");
    EXPECT_EQ(rows[0].at("trained on"), "fisher / paper");
    EXPECT_EQ(rows[0].at("tested on"), "fisher / held_out / test");
    EXPECT_EQ(rows[0].at("seed"), 3);
    EXPECT_EQ(rows[0].at("accuracy"), 0.9);
}

TEST(SeedTable, JoinsModelsThatDifferInTheirSeedsAlone) {
    const std::vector<Evaluation> evaluations{model(1, "a", 8), model(2, "a", 10), model(1, "b", 5),
                                              model(1, "c", 5), model(2, "c", 6),  model(2, "c", 7)};
    const Json rows = seed_table(evaluations, {}).json();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].at("seeds"), 2);
    EXPECT_DOUBLE_EQ(rows[0].at("accuracy").get<double>(), 0.9);
    EXPECT_DOUBLE_EQ(rows[0].at("accuracy sd").get<double>(), std::sqrt(0.02));
}

TEST(Report, HasEveryDetectorInEveryPart) {
    const KnownDataset known;
    std::vector<Evaluation> evaluations;
    for (const Detector& rule : fitted_rules(known.data(), dataset::LabelRule::fisher, dataset::Split::held_out)) {
        evaluations.push_back(evaluate(known.data(), rule, {}));
    }
    const Json json = evaluation_json(known.data(), evaluations, {});
    EXPECT_EQ(json.at("detectors").size(), evaluations.size());
    EXPECT_EQ(json.at("confusion").size(), evaluations.size());
    EXPECT_EQ(json.at("physics").size(), 2 * evaluations.size());
    EXPECT_EQ(json.at("calibration").size(), 1U);
    EXPECT_EQ(json.at("reliability").size(), reliability_bin_count);
    EXPECT_TRUE(json.at("seeds").empty());
    // one group by scene, lidar, odometry, method and update distance each, and two by the number of particles
    EXPECT_EQ(json.at("groups").size(), 7 * evaluations.size());
}

}  // namespace
}  // namespace ddtool::judge
