#include "train/torch/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::train_torch {
namespace {

const torch::Tensor logits = torch::tensor({{0.5F, -1.0F}, {2.0F, 3.0F}});
const torch::Tensor classes = torch::tensor({0, 1}, torch::kInt64);

double log1p_exp(double x) { return std::log1p(std::exp(x)); }

TEST(Losses, CrossEntropyIsTheNegativeLogOfTheSoftmax) {
    const torch::Tensor losses = sample_losses("cross-entropy", logits, classes);
    EXPECT_NEAR(losses[0].item<double>(), log1p_exp(-1.5), 1e-6);
    EXPECT_NEAR(losses[1].item<double>(), log1p_exp(-1.0), 1e-6);
}

TEST(Losses, BceTakesEachLogitForAClassOfItsOwn) {
    const torch::Tensor losses = sample_losses("bce", logits, classes);
    EXPECT_NEAR(losses[0].item<double>(), 0.5 * (log1p_exp(-0.5) + log1p_exp(-1.0)), 1e-6);
    EXPECT_NEAR(losses[1].item<double>(), 0.5 * (log1p_exp(2.0) + log1p_exp(-3.0)), 1e-6);
}

TEST(Losses, SwappingTheClassesSwapsTheLogits) {
    for (const char* loss : {"cross-entropy", "bce"}) {
        const torch::Tensor straight = sample_losses(loss, logits, classes);
        const torch::Tensor swapped = sample_losses(loss, logits.flip(1), 1 - classes);
        EXPECT_TRUE(torch::allclose(straight, swapped)) << loss;
    }
}

TEST(Losses, AnUnknownLossIsNamed) { EXPECT_THROW(sample_losses("hinge", logits, classes), UsageError); }

}  // namespace
}  // namespace ddtool::train_torch
