#include "train/torch/losses.hpp"

#include "ddtool/base/error.hpp"

namespace ddtool::train_torch {

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

torch::Tensor output_values(const std::string& loss, const torch::Tensor& logits) {
    return loss == "bce" ? torch::sigmoid(logits) : torch::softmax(logits, 1);
}

torch::Tensor ClassWeights::at(const torch::Tensor& classes) const {
    const auto options = torch::TensorOptions().dtype(torch::kFloat32).device(classes.device());
    return torch::tensor({of[0], of[1]}, options).index_select(0, classes);
}

ClassWeights class_weights(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                           const train::TrainSettings& settings) {
    if (!settings.class_weights) {
        return {};
    }
    const dataset::LabelRule rule = train::label_rule_of(settings);
    std::array<double, 2> counts{};
    for (const std::size_t sample : samples) {
        counts.at(data.sample(sample).label_of(rule) == dataset::Label::degenerate ? 1 : 0) += 1.0;
    }
    const double all = counts[0] + counts[1];
    return {{all / (2.0 * counts[0]), all / (2.0 * counts[1])}};
}

}  // namespace ddtool::train_torch
