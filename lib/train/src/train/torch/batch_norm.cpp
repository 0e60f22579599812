#include "train/torch/batch_norm.hpp"

namespace ddtool::train_torch {

BatchNorm::BatchNorm(std::int64_t channels, const BatchNormOptions& options) : options_(options) {
    weight_ = register_parameter("weight", torch::ones(channels));
    bias_ = register_parameter("bias", torch::zeros(channels));
    running_mean_ = register_buffer("running_mean", torch::zeros(channels));
    running_variance_ = register_buffer("running_var", torch::ones(channels));
}

torch::Tensor BatchNorm::forward(const torch::Tensor& input) {
    if (is_training() && sum_over_ranks_) {
        return forward_synchronous(input);
    }
    return torch::batch_norm(input, weight_, bias_, running_mean_, running_variance_, is_training(), options_.momentum,
                             options_.epsilon, /*cudnn_enabled=*/true);
}

torch::Tensor BatchNorm::forward_synchronous(const torch::Tensor& input) {
    const torch::Tensor x = input.to(torch::kFloat);
    const std::int64_t channels = weight_.numel();
    const torch::Tensor own_count = torch::full({1}, static_cast<double>(x.numel() / channels), x.options());
    const torch::Tensor sums = sum_over_ranks_(torch::cat({x.sum({0, 2, 3}), x.square().sum({0, 2, 3}), own_count}));
    const torch::Tensor count = sums.narrow(0, 2 * channels, 1);
    const torch::Tensor mean = sums.narrow(0, 0, channels) / count;
    // Because of rounding, E[x^2] - E[x]^2 can be below zero.
    const torch::Tensor variance = (sums.narrow(0, channels, channels) / count - mean.square()).clamp_min(0.0);
    update_running(mean, variance * count / (count - 1.0));
    const torch::Tensor scale = weight_ * torch::rsqrt(variance + options_.epsilon);
    const torch::Tensor shift = bias_ - mean * scale;
    return (x * scale.view({1, -1, 1, 1}) + shift.view({1, -1, 1, 1})).to(input.scalar_type());
}

void BatchNorm::update_running(const torch::Tensor& mean, const torch::Tensor& unbiased_variance) {
    const torch::NoGradGuard no_grad;
    running_mean_.lerp_(mean, options_.momentum);
    running_variance_.lerp_(unbiased_variance, options_.momentum);
}

void set_sum_over_ranks(torch::nn::Module& network, const SumOverRanks& sum) {
    network.apply([&](torch::nn::Module& module) {
        if (auto* norm = module.as<BatchNorm>()) {
            norm->set_sum_over_ranks(sum);
        }
    });
}

}  // namespace ddtool::train_torch
