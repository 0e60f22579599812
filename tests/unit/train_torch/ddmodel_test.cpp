#include "train/torch/ddmodel.hpp"

#include <gmock/gmock.h>

#include "formula_weights.hpp"
#include "near.hpp"
#include "parameter_count.hpp"

namespace ddtool::train_torch {
namespace {

using testing::ElementsAre;

/// The logits after one pass in training mode, which sets the statistics, and one in evaluation mode.
torch::Tensor formula_logits(const network::DDModelTable& table) {
    const torch::NoGradGuard no_grad;
    DDModel network(table, 224);
    fill_by_formula(network);
    const torch::Tensor images = formula_images(2, 224);
    network.forward(images);
    network.eval();
    return network.forward(images);
}

TEST(DDModel, BackboneEndsInThePapersMap) {
    DDModel network(network::ddmodel_table(), 224);
    network.eval();
    const torch::NoGradGuard no_grad;
    const torch::Tensor map = network.feature_map(formula_images(2, 224));
    EXPECT_THAT(map.sizes(), ElementsAre(2, 256, 28, 28));
    EXPECT_THAT(network.features(map).sizes(), ElementsAre(2, 64));
}

TEST(DDModel, LiteBackboneEndsInASmallMap) {
    DDModel network(network::ddmodel_lite_table(), 224);
    network.eval();
    const torch::NoGradGuard no_grad;
    const torch::Tensor map = network.feature_map(formula_images(2, 224));
    EXPECT_THAT(map.sizes(), ElementsAre(2, 64, 7, 7));
    EXPECT_THAT(network.features(map).sizes(), ElementsAre(2, 64));
}

TEST(DDModel, HasTheDocumentedNumberOfParameters) {
    EXPECT_EQ(parameter_count(DDModel(network::ddmodel_table(), 224)), 1'327'458);
    EXPECT_EQ(parameter_count(DDModel(network::ddmodel_lite_table(), 224)), 118'770);
}

// The number of blocks in a table is free: each additional block adds two convolutions and their normalisations.
TEST(DDModel, GrowsByTheBlocksOfItsTable) {
    network::DDModelTable deeper = network::ddmodel_lite_table();
    deeper.groups.back().blocks = 3;
    const std::int64_t width = 64;
    const std::int64_t block = 2 * (width * width * 3 * 3 + 2 * width);
    EXPECT_EQ(parameter_count(DDModel(deeper, 224)),
              parameter_count(DDModel(network::ddmodel_lite_table(), 224)) + 2 * block);
}

TEST(DDModel, FixedWeightsGiveTheStoredLogits) {
    EXPECT_TRUE(
        near(formula_logits(network::ddmodel_table()), torch::tensor({{-2.6458, 0.3213}, {-2.6384, 0.3208}}), 2e-4));
    EXPECT_TRUE(near(formula_logits(network::ddmodel_lite_table()),
                     torch::tensor({{0.4634, -2.2040}, {0.5624, -2.0115}}), 2e-4));
}

TEST(DDModel, KnowsWhereInTheImageADotIs) {
    DDModel network(network::ddmodel_lite_table(), 224);
    fill_by_formula(network);
    network.eval();
    const torch::NoGradGuard no_grad;
    torch::Tensor images = torch::zeros({2, 1, 224, 224});
    images[0][0].slice(0, 40, 60).slice(1, 40, 60).fill_(1.0);
    images[1][0].slice(0, 40 + 96, 60 + 96).slice(1, 40, 60).fill_(1.0);
    const torch::Tensor map = network.feature_map(images);
    EXPECT_FALSE(near(network.features(map)[0], network.features(map)[1], 1e-3));
}

}  // namespace
}  // namespace ddtool::train_torch
