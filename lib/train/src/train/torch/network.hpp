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
    /// images: [n, 1, size_px, size_px], 0 or 1. Returns logits [n, 2]: not degenerate, degenerate; float32 whatever
    /// the autocast.
    virtual torch::Tensor forward(const torch::Tensor& images) = 0;
};

/// Names of the table of networks.
std::vector<std::string> network_names();

/// A network with weights drawn from LibTorch's random state, for images of that size. Throws UsageError for a name
/// that is not in the table.
std::shared_ptr<Network> make_network(const std::string& name, std::size_t size_px);

}  // namespace ddtool::train_torch
