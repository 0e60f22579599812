#include <gmock/gmock.h>
#include <torch/torch.h>

#include "base/error.hpp"
#include "formula_weights.hpp"
#include "models/ddmodel.hpp"
#include "models/mobilenetv3.hpp"
#include "models/network.hpp"
#include "thrown_text.hpp"

namespace ddtool::models {
namespace {

using test::thrown_text;
using testing::ElementsAre;
using testing::HasSubstr;

std::int64_t parameter_count(const torch::nn::Module& network) {
    std::int64_t count = 0;
    for (const torch::Tensor& parameter : network.parameters()) {
        count += parameter.numel();
    }
    return count;
}

TEST(Networks, AreNamedInOneTable) {
    EXPECT_THAT(network_names(), ElementsAre("ddmodel", "ddmodel-lite", "mobilenetv3"));
    EXPECT_THAT(thrown_text<UsageError>([] { make_network("resnet", 224); }), HasSubstr("ddmodel-lite"));
}

TEST(DDModel, BackboneEndsInThePapersMap) {
    DDModel network(ddmodel_table(), 224);
    network.eval();
    const torch::NoGradGuard no_grad;
    const torch::Tensor map = network.feature_map(formula_images(2, 224));
    EXPECT_THAT(map.sizes(), ElementsAre(2, 256, 28, 28));
    EXPECT_THAT(network.features(map).sizes(), ElementsAre(2, 64));
}

TEST(DDModelLite, IsSmall) {
    DDModel network(ddmodel_lite_table(), 224);
    network.eval();
    const torch::NoGradGuard no_grad;
    EXPECT_THAT(network.feature_map(formula_images(2, 224)).sizes(), ElementsAre(2, 64, 7, 7));
    EXPECT_LT(parameter_count(network), 150'000);
}

TEST(MobileNetV3, HasTorchvisionsParameterCount) {
    EXPECT_EQ(parameter_count(MobileNetV3({.in_channels = 3, .classes = 1000})), 5'483'032);
}

class EveryNetwork : public testing::TestWithParam<std::string> {};

TEST_P(EveryNetwork, MakesTwoLogitsForImagesOfAnySize) {
    for (const std::int64_t size_px : {64, 97, 224}) {
        const auto network = make_network(GetParam(), static_cast<std::size_t>(size_px));
        const torch::Tensor logits = network->forward(formula_images(3, size_px));
        EXPECT_THAT(logits.sizes(), ElementsAre(3, 2));
        EXPECT_TRUE(logits.isfinite().all().item<bool>());
    }
}

INSTANTIATE_TEST_SUITE_P(Networks, EveryNetwork, testing::ValuesIn(network_names()), [](const auto& named) {
    std::string name = named.param;
    std::erase(name, '-');
    return name;
});

}  // namespace
}  // namespace ddtool::models
