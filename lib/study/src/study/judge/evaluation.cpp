#include "study/judge/evaluation.hpp"

#include <algorithm>

#include "study/judge/samples.hpp"

namespace ddtool::judge {
namespace {

using dataset::Dataset;
using Indices = std::vector<std::size_t>;

Indices without_label(const Dataset& data, dataset::LabelRule label) {
    Indices samples;
    for (std::size_t index = 0; index < data.size(); ++index) {
        if (data.sample(index).label_of(label) == dataset::Label::unknown) {
            samples.push_back(index);
        }
    }
    return samples;
}

std::vector<double> scored(const Dataset& data, const Detector& detector, const Indices& samples) {
    return scores_of(data, samples, detector.score, detector.name);
}

Calibration calibration_of(const Evaluation& evaluation, const Dataset& data, const Task& task) {
    const LabelledSamples validation = labelled_samples(data, task.label, task.split, dataset::Part::validation);
    Calibration calibration;
    calibration.bins = reliability(evaluation.scores, evaluation.samples.degenerate);
    calibration.error = expected_calibration_error(calibration.bins);
    calibration.temperature =
        fitted_temperature(scored(data, evaluation.detector, validation.indices), validation.degenerate);
    std::vector<double> scaled = evaluation.scores;
    for (double& degree : scaled) {
        degree = at_temperature(degree, calibration.temperature);
    }
    calibration.error_at_temperature = expected_calibration_error(reliability(scaled, evaluation.samples.degenerate));
    return calibration;
}

/// The agreement with the physics, over the tested samples and the samples without a label. No detector can have been
/// trained on the latter.
std::vector<PhysicalAgreement> physics_of(const Evaluation& evaluation, const Dataset& data, const Task& task) {
    Indices samples = without_label(data, task.label);
    std::vector<double> scores = scored(data, evaluation.detector, samples);
    samples.insert(samples.end(), evaluation.samples.indices.begin(), evaluation.samples.indices.end());
    scores.insert(scores.end(), evaluation.scores.begin(), evaluation.scores.end());
    return physical_agreement(data, samples, scores);
}

}  // namespace

std::string name_of(const Task& task) {
    return std::string(dataset::label_rule_names[index_of(task.label)]) + " / " +
           dataset::split_names[index_of(task.split)] + " / " + dataset::part_names[index_of(task.part)];
}

Evaluation evaluate(const Dataset& data, const Detector& detector, const Task& task) {
    Evaluation evaluation;
    evaluation.detector = detector;
    evaluation.samples = labelled_samples(data, task.label, task.split, task.part);
    evaluation.scores = scored(data, detector, evaluation.samples.indices);
    evaluation.performance = performance_of(detector, evaluation.scores, evaluation.samples.degenerate);
    if (detector.is_degree) {
        evaluation.calibration = calibration_of(evaluation, data, task);
    }
    evaluation.physics = physics_of(evaluation, data, task);
    return evaluation;
}

std::span<const Evaluation> detailed(std::span<const Evaluation> evaluations) {
    const auto models = std::find_if_not(evaluations.begin(), evaluations.end(),
                                         [](const Evaluation& each) { return each.detector.is_model(); });
    return models == evaluations.begin() ? evaluations.last(1) : std::span(evaluations.begin(), models);
}

Performance performance_at(const Evaluation& evaluation, std::span<const std::size_t> places) {
    std::vector<double> scores;
    std::vector<bool> degenerate;
    for (const std::size_t place : places) {
        scores.push_back(evaluation.scores[place]);
        degenerate.push_back(evaluation.samples.degenerate[place]);
    }
    return performance_of(evaluation.detector, scores, degenerate);
}

}  // namespace ddtool::judge
