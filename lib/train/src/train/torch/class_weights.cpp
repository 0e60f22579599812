#include "train/torch/class_weights.hpp"

namespace ddtool::training {

torch::Tensor ClassWeights::at(const torch::Tensor& classes) const {
    const auto options = torch::TensorOptions().dtype(torch::kFloat32).device(classes.device());
    return torch::tensor({of[0], of[1]}, options).index_select(0, classes);
}

ClassWeights class_weights(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                           const learning::TrainSettings& settings) {
    if (!settings.class_weights) {
        return {};
    }
    const dataset::LabelRule rule = learning::label_rule_of(settings);
    std::array<double, 2> counts{};
    for (const std::size_t sample : samples) {
        counts.at(data.sample(sample).label_of(rule) == dataset::Label::degenerate ? 1 : 0) += 1.0;
    }
    const double all = counts[0] + counts[1];
    return {{all / (2.0 * counts[0]), all / (2.0 * counts[1])}};
}

}  // namespace ddtool::training
