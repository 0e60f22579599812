#include "train/torch/optimizers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ddtool/base/error.hpp"

namespace ddtool::train_torch {

std::unique_ptr<torch::optim::Optimizer> make_optimizer(const train::OptimizerSettings& settings,
                                                        const std::vector<torch::Tensor>& parameters) {
    namespace optim = torch::optim;
    const double rate = settings.learning_rate;
    const double decay = settings.weight_decay;
    if (settings.name == "adam") {
        return std::make_unique<optim::Adam>(parameters, optim::AdamOptions(rate).weight_decay(decay));
    }
    if (settings.name == "adamw") {
        return std::make_unique<optim::AdamW>(parameters, optim::AdamWOptions(rate).weight_decay(decay));
    }
    if (settings.name == "rmsprop") {
        return std::make_unique<optim::RMSprop>(parameters, optim::RMSpropOptions(rate).weight_decay(decay));
    }
    throw UsageError("optimizer.name: expected adam, rmsprop or adamw, not " + settings.name);
}

double learning_rate(const train::OptimizerSettings& settings, std::size_t step, std::size_t steps) {
    const double warm_up = std::max(1.0, settings.warm_up_share * static_cast<double>(steps));
    const double at = static_cast<double>(step) + 1.0;
    if (at < warm_up) {
        return settings.learning_rate * at / warm_up;
    }
    const double share = (at - warm_up) / std::max(1.0, static_cast<double>(steps) - warm_up);
    const double cosine = 0.5 * (1.0 + std::cos(std::numbers::pi * std::min(1.0, share)));
    return settings.learning_rate * (settings.final_rate_share + (1.0 - settings.final_rate_share) * cosine);
}

void set_learning_rate(torch::optim::Optimizer& optimizer, double rate) {
    for (torch::optim::OptimizerParamGroup& group : optimizer.param_groups()) {
        group.options().set_lr(rate);
    }
}

}  // namespace ddtool::train_torch
