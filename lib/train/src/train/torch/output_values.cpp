#include "train/torch/output_values.hpp"

namespace ddtool::inference {

torch::Tensor output_values(const std::string& loss, const torch::Tensor& logits) {
    return loss == "bce" ? torch::sigmoid(logits) : torch::softmax(logits, 1);
}

}  // namespace ddtool::inference
