#include "train/torch/validation.hpp"

#include "scores/confusion.hpp"
#include "scores/rank_statistics.hpp"
#include "train/batch_loader.hpp"
#include "train/torch/batch_tensors.hpp"
#include "train/torch/losses.hpp"
#include "train/torch/mixed_precision.hpp"

namespace ddtool::train_torch {
namespace {

struct Scores {
    /// logit of "degenerate" minus logit of "not degenerate"; the decision is "degenerate" where it is positive
    std::vector<double> margins;
    std::vector<bool> degenerate;
    double loss = 0.0;
};

void add(Scores& scores, const torch::Tensor& logits, const torch::Tensor& classes,
         const train::TrainSettings& settings, const ClassWeights& weights) {
    scores.loss += (sample_losses(settings.loss, logits, classes) * weights.at(classes)).sum().item<double>();
    const torch::Tensor margins = (logits.select(1, 1) - logits.select(1, 0)).to(torch::kCPU, torch::kFloat64);
    const torch::Tensor truth = classes.to(torch::kCPU);
    for (std::int64_t index = 0; index < margins.size(0); ++index) {
        scores.margins.push_back(margins[index].item<double>());
        scores.degenerate.push_back(truth[index].item<std::int64_t>() == 1);
    }
}

ValidationResult result_of(const Scores& scores) {
    const Confusion decisions = confusion_of(scores.margins, scores.degenerate, 0.0);
    return {.loss = scores.loss / static_cast<double>(decisions.count()),
            .accuracy = decisions.accuracy(),
            .f1 = decisions.f1(),
            .auc = roc_auc(scores.margins, scores.degenerate)};
}

}  // namespace

ValidationResult validate(Network& network, const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                          const train::TrainSettings& settings, const ClassWeights& weights, torch::Device device) {
    const torch::NoGradGuard no_gradients;
    network.eval();
    Scores scores;
    train::BatchLoader loader(data, train::evaluation_pass(samples, settings.batch_size), settings, nullptr);
    train::Batch batch;
    while (loader.next(batch)) {
        const BatchTensors tensors = tensors_of(batch, device);
        const MixedPrecision precision(settings.precision, device.type());
        add(scores, network.forward(tensors.images), tensors.classes, settings, weights);
    }
    return result_of(scores);
}

}  // namespace ddtool::train_torch
