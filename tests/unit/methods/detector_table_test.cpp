#include "ddtool/methods/detector_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ddtool/network/shipped_model.hpp"
#include "swarms.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

ParticleSnapshot step_of(double matched_sd_m, double way_m = 0.1) {
    ParticleSnapshot swarm;
    swarm.odometry_motion = {way_m, 0.0, 0.0};
    swarm.particles = test::normal_swarm(100, 1, {matched_sd_m, 0.0}, 0.1);
    return swarm;
}

TEST(DetectorTable, MakesEveryDetectorItNames) {
    const DetectorTable table;
    EXPECT_FALSE(table.make("none", {}, {}));
    for (const char* name : {"always", "covariance", "step-spread", "neff", "oracle"}) {
        EXPECT_TRUE(table.make(name, {}, {})) << name;
        EXPECT_EQ(table.model_fingerprint(name), "");
    }
    EXPECT_TRUE(table.make(shipped_model_name, {}, {}));
    EXPECT_NE(table.model_fingerprint(shipped_model_name), "");
    EXPECT_TRUE(table.make(paper_model_name, {}, {}));
    EXPECT_NE(table.model_fingerprint(paper_model_name), table.model_fingerprint(shipped_model_name));
}

TEST(DetectorTable, NamesWhatItKnows) {
    const std::string text = test::thrown_text<UsageError>([] { (void)DetectorTable().make("model.pt", {}, {}); });
    EXPECT_THAT(text, testing::HasSubstr("filter.detector: expected always, covariance, ddmodel-lite, ddmodel-paper, "
                                         "neff, none, oracle, step-spread"));
    EXPECT_THAT(text, testing::HasSubstr("not 'model.pt'"));
}

TEST(DetectorTable, LoadsFilesByTheirEnding) {
    DetectorTable table;
    std::string loaded;
    table.add_file_kind(".pt", [&](const std::string& file) {
        loaded = file;
        return [](const ParticleSnapshot&) { return Degeneracy{0.7}; };
    });
    EXPECT_EQ(table.model_fingerprint("some/model.pt"), "unreadable");
    EXPECT_EQ(table.make("some/model.pt", {}, {})(step_of(0.1)).degree, 0.7);
    EXPECT_EQ(loaded, "some/model.pt");
    EXPECT_THAT(test::thrown_text<UsageError>([&] { (void)table.make("model.onnx", {}, {}); }),
                testing::HasSubstr("a file *.pt"));
}

/// A detector that answers 1, 2, 3 and so on, one more each time it is asked.
DegeneracyDetector counting() {
    return [calls = 0](const ParticleSnapshot&) mutable { return Degeneracy{static_cast<double>(++calls)}; };
}

TEST(Gate, InDoubtAsksOnlyWhereTheMatchLeavesMuch) {
    DetectionSettings settings;
    settings.doubt_share = 0.3;
    const DegeneracyDetector detector = gated("in-doubt", counting(), settings);
    EXPECT_EQ(detector(step_of(0.01)).degree, 0.0);
    EXPECT_EQ(detector(step_of(0.05)).degree, 1.0) << "the first time that it is asked";
}

TEST(Gate, InDoubtKeepsAnAnswerForAWhile) {
    DetectionSettings settings;
    settings.every_m = 1.0;
    const DegeneracyDetector detector = gated("in-doubt", counting(), settings);
    EXPECT_EQ(detector(step_of(0.1, 0.4)).degree, 1.0);
    EXPECT_EQ(detector(step_of(0.1, 0.4)).degree, 1.0);
    EXPECT_EQ(detector(step_of(0.1, 0.4)).degree, 1.0);
    EXPECT_EQ(detector(step_of(0.1, 0.4)).degree, 2.0);
}

TEST(Gate, CopiesShareNothing) {
    const DegeneracyDetector one = gated("in-doubt", counting(), {});
    const DegeneracyDetector other = one;
    EXPECT_EQ(one(step_of(0.1)).degree, 1.0);
    EXPECT_EQ(other(step_of(0.1)).degree, 1.0);
}

TEST(Gate, NoneAsksAtEveryUpdate) {
    const DegeneracyDetector detector = gated("none", counting(), {});
    EXPECT_EQ(detector(step_of(0.01)).degree, 1.0) << "where nothing is in doubt";
    EXPECT_EQ(detector(step_of(0.1)).degree, 2.0);
    EXPECT_EQ(detector(step_of(0.1)).degree, 3.0) << "and again at once";
}

TEST(Gate, OfNoDetectorIsNoDetector) { EXPECT_FALSE(gated("in-doubt", {}, {})); }

TEST(Gate, IsOneOfTheKnown) {
    EXPECT_THAT(test::thrown_text<UsageError>([] { (void)gated("open", counting(), {}); }),
                testing::HasSubstr("filter.gate: expected in-doubt, none, not 'open'"));
}

}  // namespace
}  // namespace ddtool
