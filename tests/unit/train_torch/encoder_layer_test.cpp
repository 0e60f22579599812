#include "train/torch/ddmodel.hpp"

#include <gmock/gmock.h>

#include "formula_weights.hpp"
#include "near.hpp"

namespace ddtool::train_torch {
namespace {

constexpr std::int64_t width = 12;

torch::Tensor parameter(const torch::nn::Module& module, const std::string& name) {
    return module.named_parameters()[name];
}

/// The result of LibTorch's own attention, which takes [tokens, n, width], with the weights of this layer.
torch::Tensor reference_attention(const EncoderLayer& layer, std::int64_t heads, const torch::Tensor& x) {
    torch::nn::MultiheadAttention attention(width, heads);
    attention->in_proj_weight.copy_(parameter(layer, "query_key_value.weight"));
    attention->in_proj_bias.copy_(parameter(layer, "query_key_value.bias"));
    attention->out_proj->weight.copy_(parameter(layer, "attention_out.weight"));
    attention->out_proj->bias.copy_(parameter(layer, "attention_out.bias"));
    const torch::Tensor turned = x.transpose(0, 1);
    return std::get<0>(attention->forward(turned, turned, turned)).transpose(0, 1);
}

torch::Tensor reference_norm(const EncoderLayer& layer, const std::string& name, const torch::Tensor& x) {
    return torch::layer_norm(x, {width}, parameter(layer, name + ".weight"), parameter(layer, name + ".bias"));
}

torch::Tensor reference_linear(const EncoderLayer& layer, const std::string& name, const torch::Tensor& x) {
    return torch::linear(x, parameter(layer, name + ".weight"), parameter(layer, name + ".bias"));
}

class EncoderLayerOfHeads : public testing::TestWithParam<std::int64_t> {
protected:
    EncoderLayerOfHeads() { fill_by_formula(layer_); }

    torch::NoGradGuard no_grad_;
    EncoderLayer layer_{{.width = width, .heads = GetParam(), .feed_forward = 20}};
    torch::Tensor tokens_ = formula_tensor({3, 7, width}, 0.3).to(torch::kFloat);
};

TEST_P(EncoderLayerOfHeads, AgreesWithLibTorchsOwnAttention) {
    const torch::Tensor attended =
        tokens_ + reference_attention(layer_, GetParam(), reference_norm(layer_, "attention_norm", tokens_));
    const torch::Tensor hidden =
        torch::relu(reference_linear(layer_, "feed_forward_in", reference_norm(layer_, "feed_forward_norm", attended)));
    const torch::Tensor expected = attended + reference_linear(layer_, "feed_forward_out", hidden);
    EXPECT_TRUE(near(layer_.forward(tokens_), expected, 1e-5));
}

TEST_P(EncoderLayerOfHeads, PermutedTokensGivePermutedAnswers) {
    const torch::Tensor order = torch::tensor({4, 0, 6, 2, 5, 1, 3});
    EXPECT_TRUE(
        near(layer_.forward(tokens_.index_select(1, order)), layer_.forward(tokens_).index_select(1, order), 1e-5));
}

INSTANTIATE_TEST_SUITE_P(Heads, EncoderLayerOfHeads, testing::Values(1, 2, 3));

}  // namespace
}  // namespace ddtool::train_torch
