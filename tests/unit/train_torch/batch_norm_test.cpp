#include "train/torch/batch_norm.hpp"

#include <gmock/gmock.h>

#include "formula_weights.hpp"
#include "near.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {
namespace {

constexpr std::int64_t channels = 3;

std::shared_ptr<BatchNorm> filled_norm() {
    auto norm = std::make_shared<BatchNorm>(channels);
    fill_by_formula(*norm);
    return norm;
}

torch::Tensor batch_of(std::int64_t n, double phase) {
    return formula_tensor({n, channels, 4, 5}, phase).mul(2.0).add(0.7).to(torch::kFloat).requires_grad_();
}

/// What a rank sends to the other one.
torch::Tensor sent_by(const torch::Tensor& batch) {
    torch::Tensor sent;
    const auto norm = filled_norm();
    norm->set_sum_over_ranks([&](const torch::Tensor& own) { return sent = own; });
    norm->forward(batch);
    return sent;
}

/// The layer of a rank that has `batch`, while the other rank has `other`.
std::shared_ptr<BatchNorm> norm_beside(const torch::Tensor& other) {
    auto norm = filled_norm();
    norm->set_sum_over_ranks([sent = sent_by(other)](const torch::Tensor& own) { return own + sent; });
    return norm;
}

/// A loss with another gradient for each value.
torch::Tensor loss_of(const torch::Tensor& output) {
    return (output.square() * formula_tensor(output.sizes(), 0.9).to(torch::kFloat)).sum();
}

TEST(BatchNorm, TwoRanksAreOneWithBothBatches) {
    const torch::Tensor first = batch_of(2, 0.1);
    const torch::Tensor second = batch_of(5, 0.2);  // the ranks' batches may differ in size
    const auto whole = filled_norm();
    const auto rank_0 = norm_beside(second);
    const auto rank_1 = norm_beside(first);

    const torch::Tensor expected = whole->forward(torch::cat({first, second}));
    const torch::Tensor both = torch::cat({rank_0->forward(first), rank_1->forward(second)});
    EXPECT_TRUE(near(both, expected, 1e-5));

    const std::vector<torch::Tensor> wanted =
        torch::autograd::grad({loss_of(expected)}, {first, second, whole->parameters()[0], whole->parameters()[1]});
    std::vector<torch::Tensor> of_ranks = rank_0->parameters();
    for (const torch::Tensor& parameter : rank_1->parameters()) {
        of_ranks.push_back(parameter);
    }
    const std::vector<torch::Tensor> got =
        torch::autograd::grad({loss_of(both)}, {first, second, of_ranks[0], of_ranks[1], of_ranks[2], of_ranks[3]});
    EXPECT_TRUE(near(got[0], wanted[0], 1e-4));
    EXPECT_TRUE(near(got[1], wanted[1], 1e-4));
    EXPECT_TRUE(near(got[2] + got[4], wanted[2], 1e-3));
    EXPECT_TRUE(near(got[3] + got[5], wanted[3], 1e-3));
}

TEST(BatchNorm, RanksKeepTheStatisticsOfBothBatches) {
    const torch::Tensor first = batch_of(2, 0.1);
    const torch::Tensor second = batch_of(5, 0.2);
    const auto whole = filled_norm();
    whole->forward(torch::cat({first, second}));
    const auto rank = norm_beside(second);
    rank->forward(first);
    for (std::size_t buffer = 0; buffer < 2; ++buffer) {
        EXPECT_TRUE(near(rank->buffers()[buffer], whole->buffers()[buffer], 1e-5));
    }
    rank->eval();
    whole->eval();
    EXPECT_TRUE(near(rank->forward(first), whole->forward(first), 1e-5));
}

TEST(BatchNorm, OneRankAloneIsTheOrdinaryNorm) {
    const torch::Tensor batch = batch_of(4, 0.3);
    const auto alone = filled_norm();
    alone->set_sum_over_ranks([](const torch::Tensor& own) { return own; });
    EXPECT_TRUE(near(alone->forward(batch), filled_norm()->forward(batch), 1e-5));
    EXPECT_EQ(alone->forward(batch.to(torch::kBFloat16)).scalar_type(), torch::kBFloat16);
}

TEST(BatchNorm, EveryNormOfANetworkAsksTheRanks) {
    for (const std::string& name : network_names()) {
        const auto network = make_network(name, 64);
        std::size_t norms = 0;
        for (const auto& buffer : network->named_buffers()) {
            norms += buffer.key().ends_with("running_mean") ? 1 : 0;
        }
        std::size_t asked = 0;
        set_sum_over_ranks(*network, [&](const torch::Tensor& own) {
            ++asked;
            return own;
        });
        network->forward(formula_images(2, 64));
        EXPECT_EQ(asked, norms) << name;
    }
}

}  // namespace
}  // namespace ddtool::train_torch
