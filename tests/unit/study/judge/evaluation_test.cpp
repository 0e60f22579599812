#include "study/judge/evaluation.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "known_dataset.hpp"
#include "study/judge/mistakes.hpp"
#include "study/judge/samples.hpp"
#include "swarm/rules.hpp"

namespace ddtool::judge {
namespace {

using ddtool::test::KnownDataset;

double width_m(Particles swarm) { return spread_m(swarm, &SnapshotParticle::matched_motion); }

/// A detector that decides by the swarm's width, with this confidence. A swarm narrower than 3 cm is not degenerate.
Detector confident(double confidence) {
    Detector detector;
    detector.name = "width";
    detector.is_degree = true;
    detector.score =
        one_by_one([confidence](Particles swarm) { return width_m(swarm) > 0.03 ? confidence : 1.0 - confidence; });
    return detector;
}

TEST(Evaluate, JudgesThePartAlone) {
    const KnownDataset known(dataset::Part::test);
    const Evaluation test = evaluate(known.data(), confident(0.9), {});
    const Evaluation validation = evaluate(known.data(), confident(0.9), {.part = dataset::Part::validation});
    EXPECT_EQ(test.performance.samples, KnownDataset::of_world / 4);
    EXPECT_EQ(test.performance.degenerate_share, 0.5);
    EXPECT_EQ(test.performance.confusion.accuracy(), 0.0);
    EXPECT_EQ(test.performance.auc, 0.0);
    EXPECT_EQ(validation.performance.confusion.accuracy(), 1.0);
}

TEST(Evaluate, FitsTheTemperatureOnValidation) {
    const KnownDataset right;
    const Evaluation modest = evaluate(right.data(), confident(0.7), {});
    EXPECT_NEAR(modest.calibration->error, 0.3, 1e-9);
    EXPECT_LT(modest.calibration->temperature, 0.1) << "always right, so it may be sure";
    EXPECT_NEAR(modest.calibration->error_at_temperature, 0.0, 1e-3);
    const KnownDataset turned(dataset::Part::validation);
    const Evaluation warned = evaluate(turned.data(), confident(0.7), {});
    EXPECT_GT(warned.calibration->temperature, 10.0) << "always wrong on validation";
    EXPECT_EQ(warned.performance.confusion.accuracy(), 1.0);
}

TEST(Evaluate, AgreesWithThePhysicsWhereTheScoreFollowsIt) {
    const KnownDataset known;
    const dataset::Dataset& data = known.data();
    Detector detector = confident(0.9);
    detector.is_degree = false;
    // counts the scores: those of the unlabelled samples, which come from the log, are asked for last and in order
    std::size_t next = 0;
    const Evaluation plain = evaluate(data, detector, {});
    EXPECT_FALSE(plain.calibration);
    detector.score = one_by_one([&](Particles /*swarm*/) { return static_cast<double>(next++); });
    const Evaluation counted = evaluate(data, detector, {});
    ASSERT_EQ(counted.physics.size(), 2U);
    EXPECT_EQ(counted.physics[0].source, "log");
    EXPECT_EQ(counted.physics[0].samples, KnownDataset::of_log);
    EXPECT_TRUE(std::isnan(counted.physics[0].auc));
    EXPECT_EQ(plain.physics[1].source, "world");
    EXPECT_EQ(plain.physics[1].samples, KnownDataset::of_world / 4);
    EXPECT_EQ(plain.physics[1].auc, 1.0);
    detector.score = one_by_one(width_m);
    for (const PhysicalAgreement& physics : evaluate(data, detector, {}).physics) {
        EXPECT_GT(physics.weak_sd_rho, 0.8) << physics.source;
        EXPECT_NEAR(physics.information_rho, -physics.weak_sd_rho, 1e-12) << physics.source;
    }
}

TEST(Evaluate, GroupsPartTheSamples) {
    const KnownDataset known;
    const Evaluation evaluation = evaluate(known.data(), confident(0.9), {});
    for (const dataset::Grouping& grouping : dataset::groupings()) {
        std::size_t samples = 0;
        for (const auto& [key, places] : grouped(known.data(), evaluation.samples, grouping)) {
            const Performance part = performance_at(evaluation, places);
            EXPECT_EQ(part.confusion.accuracy(), 1.0);
            samples += part.samples;
        }
        EXPECT_EQ(samples, evaluation.performance.samples) << grouping.name;
    }
    EXPECT_EQ(grouped(known.data(), evaluation.samples, dataset::groupings().back()).size(), 2U);
}

TEST(Mistakes, ComeWithTheMostWrongFirst) {
    const KnownDataset known(dataset::Part::test);
    Detector detector = confident(0.9);
    detector.score = one_by_one(width_m);
    detector.threshold = 0.03;
    const Evaluation evaluation = evaluate(known.data(), detector, {});
    for (const bool degenerate : {false, true}) {
        const auto places = mistakes_of(evaluation, degenerate);
        EXPECT_EQ(places.size(), evaluation.performance.samples / 2);
        for (std::size_t i = 1; i < places.size(); ++i) {
            EXPECT_GE(std::abs(evaluation.scores[places[i - 1]] - 0.03), std::abs(evaluation.scores[places[i]] - 0.03));
        }
    }
    detector.threshold = std::nan("");
    EXPECT_THAT(mistakes_of(evaluate(known.data(), detector, {}), true), testing::IsEmpty());
}

}  // namespace
}  // namespace ddtool::judge
