#include "train/torch/mobilenetv3.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "formula_weights.hpp"
#include "near.hpp"
#include "parameter_count.hpp"

namespace ddtool::train_torch {
namespace {

using testing::ElementsAre;

/// The parameters and answers of torchvision's network, written by scripts/make-mobilenet-reference.
const nlohmann::json& reference() {
    static const auto json = nlohmann::json::parse(std::ifstream(MODELS_TEST_DIR "/mobilenetv3_reference.json"));
    return json;
}

TEST(MobileNetV3, HasTorchvisionsParameters) {
    const MobileNetV3 network({.in_channels = 3, .classes = 1000});
    EXPECT_EQ(parameter_count(network), reference()["parameters"].get<std::int64_t>());
    std::vector<std::vector<std::int64_t>> shapes;
    for (const torch::Tensor& parameter : network.parameters()) {
        shapes.push_back(parameter.sizes().vec());
    }
    EXPECT_EQ(shapes, reference()["shapes"].get<std::vector<std::vector<std::int64_t>>>());
}

// The pass in training mode makes the comparison cover the momentum and the epsilon of the statistics, too.
TEST(MobileNetV3, AnswersAsTorchvisionAfterAPassInTrainingMode) {
    const torch::NoGradGuard no_grad;
    MobileNetV3 network({.in_channels = 3, .classes = 4});
    fill_by_formula(network);
    const torch::Tensor images = formula_tensor({4, 3, 64, 64}, 0.5).gt(0.9).to(torch::kFloat);
    network.forward(images);
    network.eval();
    const torch::Tensor logits = network.forward(images);
    const auto expected = reference()["logits"].get<std::vector<std::vector<float>>>();
    ASSERT_EQ(expected.size(), 4U);
    for (std::size_t image = 0; image < expected.size(); ++image) {
        EXPECT_TRUE(near(logits[static_cast<std::int64_t>(image)], torch::tensor(expected[image]), 1e-4));
    }
}

TEST(MobileNetV3, ReadsOneChannelAndEndsInTheTablesMap) {
    const torch::NoGradGuard no_grad;
    MobileNetV3 network;
    network.eval();
    const torch::Tensor images = formula_images(2, 224);
    EXPECT_THAT(network.feature_map(images).sizes(), ElementsAre(2, 960, 7, 7));
    EXPECT_THAT(network.forward(images).sizes(), ElementsAre(2, 2));
    EXPECT_EQ(parameter_count(network), 4'204'306);  // the number in docs/models.md
}

}  // namespace
}  // namespace ddtool::train_torch
