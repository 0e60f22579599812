#include "train/torch/layers.hpp"

#include <c10/core/impl/LocalDispatchKeySet.h>

namespace ddtool::train_torch {
namespace {

torch::nn::Conv2dOptions conv_options(const ConvNormOptions& options) {
    return torch::nn::Conv2dOptions(options.in_channels, options.out_channels, options.kernel_px)
        .stride(options.stride)
        .padding(options.kernel_px / 2)
        .groups(options.groups)
        .bias(false);
}

void zero_if_defined(torch::Tensor& bias) {
    if (bias.defined()) {
        torch::nn::init::zeros_(bias);
    }
}

}  // namespace

torch::Tensor activated(const torch::Tensor& x, Activation activation) {
    switch (activation) {
        case Activation::relu:
            return torch::relu(x);
        case Activation::hard_swish:
            return torch::hardswish(x);
        case Activation::none:
            break;
    }
    return x;
}

ConvNorm::ConvNorm(const ConvNormOptions& options)
    : conv_(register_module("conv", torch::nn::Conv2d(conv_options(options)))),
      norm_(register_module("norm", std::make_shared<BatchNorm>(options.out_channels, options.norm))),
      activation_(options.activation) {}

torch::Tensor ConvNorm::forward(const torch::Tensor& x) { return activated(norm_->forward(conv_(x)), activation_); }

torch::Tensor logits_of(torch::nn::Linear& head, const torch::Tensor& features) {
    const c10::impl::ExcludeDispatchKeyGuard no_autocast(c10::autocast_dispatch_keyset);
    return head(features.to(torch::kFloat));
}

void draw_weights(torch::nn::Module& network) {
    network.apply([](torch::nn::Module& module) {
        if (auto* conv = module.as<torch::nn::Conv2dImpl>()) {
            torch::nn::init::kaiming_normal_(conv->weight, 0.0, torch::kFanOut, torch::kReLU);
            zero_if_defined(conv->bias);
        } else if (auto* linear = module.as<torch::nn::LinearImpl>()) {
            torch::nn::init::xavier_uniform_(linear->weight);
            zero_if_defined(linear->bias);
        }
    });
}

void lay_out_channels_last(torch::nn::Module& network) {
    for (torch::Tensor& parameter : network.parameters()) {
        if (parameter.dim() == 4) {
            // contiguous() is not used here: weights with one input channel count as contiguous in both layouts, so it
            // would leave them unchanged, with strides that do not identify the layout.
            parameter.set_data(parameter.detach().clone(torch::MemoryFormat::ChannelsLast));
        }
    }
}

}  // namespace ddtool::train_torch
