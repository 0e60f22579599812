#pragma once

#include <map>
#include <string>
#include <vector>

#include "network/safetensors.hpp"

namespace ddtool::network {

/// The tensors of a file, from which a network takes each of its own by name and shape.
class NamedWeights {
public:
    explicit NamedWeights(std::vector<NamedTensor> tensors);

    /// Removes a tensor and returns its values in C order. Throws Error naming the tensor if it is missing or has
    /// another shape.
    std::vector<float> take(const std::string& name, const std::vector<std::size_t>& shape);
    /// Throws Error naming a tensor that was not taken: the weights then belong to another network than the file says.
    void expect_all_taken() const;

private:
    std::map<std::string, NamedTensor> tensors_;
};

}  // namespace ddtool::network
