#include "study/ablation/inference_time.hpp"

#include <gmock/gmock.h>

#include "fake_engine.hpp"
#include "swarms.hpp"

namespace ddtool::ablation {
namespace {

TEST(InferenceTime, HandsTheSameImageOverThroughAFileAndWithoutOne) {
    const auto swarm = ddtool::test::normal_swarm(30, 1, {0.5, 0.1});
    const std::vector<judge::Particles> swarms(3, swarm);
    train::TrainSettings settings;
    settings.image.swarm = Swarm::absolute;
    test::BrightnessModel model(settings);
    EXPECT_GT(inference_time_ms(model, swarms, false), 0.0);
    const std::vector<float> direct = model.seen;
    const std::size_t runs = model.runs;
    EXPECT_GT(runs, swarms.size());
    EXPECT_GT(inference_time_ms(model, swarms, true), 0.0);
    EXPECT_EQ(model.runs, 2 * runs);
    EXPECT_EQ(model.seen, direct);
    EXPECT_THAT(direct, testing::Contains(1.0F));
}

}  // namespace
}  // namespace ddtool::ablation
