#include "study/judge/model_scorer.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "ddtool/network/network_detector.hpp"
#include "swarms.hpp"

namespace ddtool::judge {
namespace {

/// Stands in for a network. Its degree is the share of marked pixels.
class BrightnessModel : public DegreeModel {
public:
    BrightnessModel() {
        description_.network = "brightness";
        description_.image = {.swarm = Swarm::step, .size_px = 64};
        description_.seed = 7;
    }
    [[nodiscard]] const ModelDescription& description() const override { return description_; }
    void run(std::span<const float> images, std::span<double> degrees) override {
        ++batches;
        const std::size_t pixels = images.size() / degrees.size();
        ASSERT_EQ(pixels, 64U * 64U);
        for (std::size_t image = 0; image < degrees.size(); ++image) {
            const auto own = images.subspan(image * pixels, pixels);
            degrees[image] = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(pixels);
        }
    }
    ModelDescription description_;
    std::size_t batches = 0;
};

TEST(ModelScorer, ManySwarmsAtOnceAreAsOneByOne) {
    const auto model = std::make_shared<BrightnessModel>();
    const SwarmScorer scorer = scorer_of(model);
    std::vector<std::vector<SnapshotParticle>> swarms;
    for (std::size_t count = 1; count <= 70; ++count) {
        swarms.push_back(ddtool::test::normal_swarm(count, count, {0.1, 0.02}));
    }
    const std::vector<Particles> views(swarms.begin(), swarms.end());
    const std::vector<double> together = scorer(views);
    EXPECT_EQ(model->batches, 3U);
    ASSERT_EQ(together.size(), swarms.size());
    const DegeneracyDetector detector = network_detector(model);
    for (std::size_t swarm = 0; swarm < swarms.size(); ++swarm) {
        EXPECT_NEAR(detector({0, 0, {}, swarms[swarm]}).degree, together[swarm], 0.5001e-3);
    }
    EXPECT_GT(together.back(), together.front());
    EXPECT_TRUE(scorer({}).empty());
}

TEST(ModelDetector, SaysWhatItIs) {
    const auto model = std::make_shared<BrightnessModel>();
    model->description_.image.gaussian_augmentation = false;
    const Detector detector = detector_of(model);
    EXPECT_EQ(detector.name, "brightness, no augmentation");
    EXPECT_EQ(detector.swarm, "step");
    EXPECT_EQ(detector.label, "fisher");
    EXPECT_EQ(detector.seed, 7U);
    EXPECT_TRUE(detector.is_model());
}

TEST(ModelDetector, FamiliesDifferInMoreThanSeeds) {
    const auto model = std::make_shared<BrightnessModel>();
    const std::string family = detector_of(model).family;
    model->description_.seed = 8;
    model->description_.temperature = 2.0;
    EXPECT_EQ(detector_of(model).family, family);
    model->description_.split = "paper";
    EXPECT_NE(detector_of(model).family, family);
}

}  // namespace
}  // namespace ddtool::judge
