#include <gmock/gmock.h>

#include <numeric>

#include "ddtool/network/load_model.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "swarms.hpp"
#include "train/torch/exported_model.hpp"

namespace ddtool::train_torch {
namespace {

/// The degrees of random swarms of 30 particles, whose matches keep the given share of the predicted spread along x.
std::vector<double> degrees_of(DegreeModel& model, double share) {
    ParticleRenderer renderer(model.description().image);
    const std::size_t pixels = renderer.settings().size_px * renderer.settings().size_px;
    std::vector<float> images;
    std::vector<double> degrees(20);
    for (std::size_t index = 0; index < degrees.size(); ++index) {
        constexpr double predicted_m = 0.1;
        std::vector<SnapshotParticle> swarm = test::normal_swarm(30, index, {}, predicted_m);
        for (SnapshotParticle& particle : swarm) {
            particle.matched_motion = {share * particle.predicted_motion.x_m, 0.0, 0.0};
        }
        images.resize((index + 1) * pixels);
        renderer.render(swarm, std::span<float>(images).subspan(index * pixels));
    }
    model.run(images, degrees);
    return degrees;
}

double mean_degree(DegreeModel& model, double share) {
    const std::vector<double> degrees = degrees_of(model, share);
    return std::accumulate(degrees.begin(), degrees.end(), 0.0) / static_cast<double>(degrees.size());
}

class ShippedModel : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::string file(const std::string& ending) {
        return std::string(DDTOOL_MODELS "/") + GetParam() + ending;
    }
};

TEST_P(ShippedModel, CallsASwarmDegenerateThatMatchingLeavesAsWideAsItCame) {
    const auto model = load_torch_script(file(".pt"), {});
    EXPECT_GT(mean_degree(*model, 1.0), 0.9);
    EXPECT_LT(mean_degree(*model, 0.05), 0.1);
}

using ShippedWeights = ShippedModel;

TEST_P(ShippedWeights, GiveTheSameDegreesWithoutLibTorch) {
    const auto model = load_torch_script(file(".pt"), {});
    const auto native = load_model(file(".safetensors"));
    for (const double share : {0.05, 0.3, 0.6, 1.0}) {
        EXPECT_THAT(degrees_of(*native, share),
                    testing::Pointwise(testing::DoubleNear(1e-5), degrees_of(*model, share)));
    }
}

INSTANTIATE_TEST_SUITE_P(Models, ShippedModel, testing::Values("ddmodel", "ddmodel-lite"),
                         [](const auto& info) { return info.param == "ddmodel" ? "full" : "lite"; });
INSTANTIATE_TEST_SUITE_P(Models, ShippedWeights, testing::Values("ddmodel", "ddmodel-lite", "ddmodel-paper"));

}  // namespace
}  // namespace ddtool::train_torch
