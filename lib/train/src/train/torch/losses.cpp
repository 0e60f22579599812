#include "train/torch/losses.hpp"

#include "ddtool/base/error.hpp"

namespace ddtool::training {

torch::Tensor sample_losses(const std::string& loss, const torch::Tensor& logits, const torch::Tensor& classes) {
    namespace functional = torch::nn::functional;
    if (loss == "cross-entropy") {
        return functional::cross_entropy(logits, classes,
                                         functional::CrossEntropyFuncOptions().reduction(torch::kNone));
    }
    if (loss == "bce") {
        const torch::Tensor targets = torch::one_hot(classes, logits.size(1)).to(logits.dtype());
        return functional::binary_cross_entropy_with_logits(
                   logits, targets, functional::BinaryCrossEntropyWithLogitsFuncOptions().reduction(torch::kNone))
            .mean(1);
    }
    throw UsageError("loss: expected cross-entropy or bce, not " + loss);
}

}  // namespace ddtool::training
