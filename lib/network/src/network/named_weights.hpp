#pragma once

#include <map>
#include <string>
#include <vector>

#include "network/safetensors.hpp"

namespace ddtool::native {

/// The tensors of a file, for a network that takes each of its own by name and shape.
class NamedWeights {
public:
    explicit NamedWeights(std::vector<NamedTensor> tensors);

    /// Its values, C order. Throws Error naming the tensor when it is not there or has another shape.
    std::vector<float> take(const std::string& name, const std::vector<std::size_t>& shape);
    /// Throws Error naming a tensor that nobody took: the network is another than the file says.
    void expect_all_taken() const;

private:
    std::map<std::string, NamedTensor> tensors_;
};

}  // namespace ddtool::native
