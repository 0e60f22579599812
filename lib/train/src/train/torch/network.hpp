#pragma once

#include <torch/torch.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace ddtool::train_torch {

/// A network that reads the degree of degeneracy from particle images.
class Network : public torch::nn::Module {
public:
    /// images: [n, 1, size_px, size_px], 0 or 1. Returns logits [n, 2] for "not degenerate" and "degenerate", in
    /// float32 even under autocast.
    virtual torch::Tensor forward(const torch::Tensor& images) = 0;
};

/// The names of all networks.
std::vector<std::string> network_names();

/// A network for images of that size, with weights drawn from LibTorch's random state. Throws UsageError for an unknown
/// name.
std::shared_ptr<Network> make_network(const std::string& name, std::size_t size_px);

}  // namespace ddtool::train_torch
