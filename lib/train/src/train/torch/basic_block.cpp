#include "train/torch/basic_block.hpp"

namespace ddtool::models {

BasicBlock::BasicBlock(std::int64_t in_channels, std::int64_t out_channels, std::int64_t stride) {
    first_ = register_module("first", std::make_shared<ConvNorm>(ConvNormOptions{
                                          .in_channels = in_channels, .out_channels = out_channels, .stride = stride}));
    second_ = register_module(
        "second", std::make_shared<ConvNorm>(ConvNormOptions{
                      .in_channels = out_channels, .out_channels = out_channels, .activation = Activation::none}));
    if (in_channels != out_channels || stride != 1) {
        projection_ =
            register_module("projection", std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = in_channels,
                                                                                     .out_channels = out_channels,
                                                                                     .kernel_px = 1,
                                                                                     .stride = stride,
                                                                                     .activation = Activation::none}));
    }
}

torch::Tensor BasicBlock::forward(const torch::Tensor& x) {
    const torch::Tensor skip = projection_ ? projection_->forward(x) : x;
    return torch::relu(second_->forward(first_->forward(x)) + skip);
}

}  // namespace ddtool::models
