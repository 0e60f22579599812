#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <functional>

namespace ddtool::train_torch {

/// Sums a tensor over the ranks of a data-parallel training. The sum is differentiable: the gradient is summed, too.
using SumOverRanks = std::function<torch::Tensor(const torch::Tensor&)>;

struct BatchNormOptions {
    double epsilon = 1e-5;
    double momentum = 0.1;  ///< the share of the new batch in the running statistics
};

/// Batch normalisation of [n, channels, height, width] (Ioffe and Szegedy 2015). All networks here use this class, so
/// that a data-parallel training can make it synchronous.
class BatchNorm : public torch::nn::Module {
public:
    explicit BatchNorm(std::int64_t channels, const BatchNormOptions& options = {});

    torch::Tensor forward(const torch::Tensor& input);
    /// Sets how statistics are summed during training: over the batches of all ranks, or, with null, over the own batch
    /// only.
    void set_sum_over_ranks(SumOverRanks sum) { sum_over_ranks_ = std::move(sum); }

private:
    torch::Tensor forward_synchronous(const torch::Tensor& input);
    void update_running(const torch::Tensor& mean, const torch::Tensor& unbiased_variance);

    BatchNormOptions options_;
    SumOverRanks sum_over_ranks_;
    torch::Tensor weight_;  // [channels], like those below
    torch::Tensor bias_;
    torch::Tensor running_mean_;
    torch::Tensor running_variance_;
};

/// Calls set_sum_over_ranks() of every BatchNorm in the network.
void set_sum_over_ranks(torch::nn::Module& network, const SumOverRanks& sum);

}  // namespace ddtool::train_torch
