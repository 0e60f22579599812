#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <functional>

namespace ddtool::train_torch {

/// Adds a tensor up over the ranks of a data-parallel run. Differentiable: the gradient is added up over them too.
using SumOverRanks = std::function<torch::Tensor(const torch::Tensor&)>;

struct BatchNormOptions {
    double epsilon = 1e-5;
    double momentum = 0.1;  ///< the share of the new batch in the running statistics
};

/// Batch normalisation of [n, channels, height, width] (Ioffe and Szegedy 2015), the project's only one, so that a
/// data-parallel run can make it synchronous.
class BatchNorm : public torch::nn::Module {
public:
    explicit BatchNorm(std::int64_t channels, const BatchNormOptions& options = {});

    torch::Tensor forward(const torch::Tensor& input);
    /// While training, statistics are those of all ranks' batches together; null: of the own batch.
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

/// Sets it for every BatchNorm in the network.
void set_sum_over_ranks(torch::nn::Module& network, const SumOverRanks& sum);

}  // namespace ddtool::train_torch
