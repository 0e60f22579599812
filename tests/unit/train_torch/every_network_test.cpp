#include <gmock/gmock.h>
#include <torch/csrc/jit/frontend/tracer.h>
#include <torch/csrc/jit/runtime/graph_executor.h>
#include <torch/torch.h>

#include "ddtool/base/error.hpp"
#include "formula_weights.hpp"
#include "near.hpp"
#include "thrown_text.hpp"
#include "train/torch/mixed_precision.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t checked_size_px = 96;  // small, to save time

class EveryNetwork : public testing::TestWithParam<std::string> {
protected:
    std::shared_ptr<Network> network_ = make_network(GetParam(), checked_size_px);
};

TEST(NetworkTable, NamesWhatThereIs) {
    EXPECT_THAT(network_names(), ElementsAre("ddmodel", "ddmodel-lite", "ddmodel-deep", "ddmodel-lite-deep",
                                             "ddmodel-no-transformer", "ddmodel-lite-no-transformer", "mobilenetv3"));
    EXPECT_THAT(test::thrown_text<UsageError>([] { make_network("resnet", 224); }), HasSubstr("ddmodel-lite"));
}

TEST_P(EveryNetwork, MakesTwoLogitsForImagesOfAnySize) {
    for (const std::int64_t size : {64, 97, 224}) {
        const torch::NoGradGuard no_grad;
        const auto network = make_network(GetParam(), static_cast<std::size_t>(size));
        const torch::Tensor logits = network->forward(formula_images(2, size));
        EXPECT_THAT(logits.sizes(), ElementsAre(2, 2));
        EXPECT_TRUE(logits.isfinite().all().item<bool>());
    }
}

TEST_P(EveryNetwork, SameRandomStateDrawsTheSameWeights) {
    torch::manual_seed(3);
    const auto first = make_network(GetParam(), checked_size_px);
    torch::manual_seed(3);
    const auto second = make_network(GetParam(), checked_size_px);
    for (const auto& parameter : first->named_parameters()) {
        EXPECT_TRUE(parameter.value().equal(second->named_parameters()[parameter.key()])) << parameter.key();
    }
}

TEST_P(EveryNetwork, BatchOfNIsNBatchesOfOne) {
    const torch::NoGradGuard no_grad;
    network_->eval();
    const torch::Tensor images = formula_images(5, checked_size_px);
    const torch::Tensor together = network_->forward(images);
    for (std::int64_t image = 0; image < images.size(0); ++image) {
        EXPECT_TRUE(near(network_->forward(images.narrow(0, image, 1))[0], together[image], 1e-4));
    }
}

TEST_P(EveryNetwork, GradientsReachEveryParameter) {
    fill_by_formula(*network_);
    network_->forward(formula_images(4, checked_size_px)).square().sum().backward();
    for (const auto& parameter : network_->named_parameters()) {
        const torch::Tensor gradient = parameter.value().grad();
        ASSERT_TRUE(gradient.defined()) << parameter.key();
        EXPECT_TRUE(gradient.isfinite().all().item<bool>()) << parameter.key();
        EXPECT_GT(gradient.abs().max().item<double>(), 0.0) << parameter.key();
    }
}

TEST_P(EveryNetwork, LearnsEightSamplesByHeart) {
    torch::manual_seed(5);
    const auto network = make_network(GetParam(), 64);
    const torch::Tensor images = formula_images(8, 64);
    const torch::Tensor classes = torch::tensor({0, 1, 1, 0, 1, 0, 0, 1});
    torch::optim::Adam optimizer(network->parameters(), 1e-3);
    double loss = 1.0;
    for (int step = 0; step < 100 && loss > 0.02; ++step) {
        optimizer.zero_grad();
        const torch::Tensor cost = torch::nn::functional::cross_entropy(network->forward(images), classes);
        cost.backward();
        optimizer.step();
        loss = cost.item<double>();
    }
    EXPECT_LE(loss, 0.02);
}

TEST_P(EveryNetwork, Bf16IsNearAndItsLogitsAreFloat) {
    fill_by_formula(*network_);
    const torch::Tensor images = formula_images(4, checked_size_px);
    network_->forward(images);  // sets the running statistics
    network_->eval();
    const torch::NoGradGuard no_grad;
    const torch::Tensor expected = network_->forward(images);
    const MixedPrecision autocast("bf16", torch::kCPU);
    const torch::Tensor rounded = network_->forward(images);
    EXPECT_EQ(rounded.scalar_type(), torch::kFloat);
    EXPECT_TRUE(near(rounded, expected, 0.1));
    EXPECT_FALSE(rounded.equal(expected)) << "autocast did nothing";
}

TEST_P(EveryNetwork, Bf16Trains) {
    torch::Tensor cost;
    {
        const MixedPrecision autocast("bf16", torch::kCPU);
        cost = network_->forward(formula_images(4, checked_size_px)).square().sum();
    }
    cost.backward();
    for (const auto& parameter : network_->named_parameters()) {
        EXPECT_EQ(parameter.value().grad().scalar_type(), torch::kFloat) << parameter.key();
    }
}

// The layers in lib/train/src/train/torch promise the exporter that no view() depends on the traced batch's size.
TEST_P(EveryNetwork, TraceOfTwoAnswersForAnyBatch) {
    network_->eval();
    for (torch::Tensor& parameter : network_->parameters()) {
        parameter.set_requires_grad(false);
    }
    const auto traced = torch::jit::tracer::trace(
        {formula_images(2, checked_size_px)},
        [&](const torch::jit::Stack& inputs) -> torch::jit::Stack { return {network_->forward(inputs[0].toTensor())}; },
        [](const torch::Tensor&) { return ""; });
    torch::jit::GraphExecutor executor(traced.first->graph, GetParam());
    for (const std::int64_t n : {1, 2, 7}) {
        const torch::Tensor images = formula_images(n, checked_size_px);
        torch::jit::Stack stack{images};
        executor.run(stack);
        EXPECT_TRUE(near(stack.back().toTensor(), network_->forward(images), 1e-5)) << n;
    }
}

TEST_P(EveryNetwork, ConvolutionsAreChannelsLast) {
    for (const torch::Tensor& parameter : network_->parameters()) {
        if (parameter.dim() == 4) {
            EXPECT_EQ(parameter.suggest_memory_format(), torch::MemoryFormat::ChannelsLast) << parameter.sizes();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Networks, EveryNetwork, testing::ValuesIn(network_names()), [](const auto& named) {
    std::string name = named.param;
    std::erase(name, '-');
    return name;
});

}  // namespace
}  // namespace ddtool::train_torch
