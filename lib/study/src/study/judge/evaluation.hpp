#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scores/calibration.hpp"
#include "study/judge/detector.hpp"
#include "study/judge/physical_agreement.hpp"
#include "study/judge/samples.hpp"

namespace ddtool::judge {

/// The samples and labels that detectors are judged on.
struct Task {
    dataset::LabelRule label = dataset::LabelRule::fisher;
    dataset::Split split = dataset::Split::held_out;
    dataset::Part part = dataset::Part::test;
};

/// "fisher / held_out / test".
std::string name_of(const Task& task);

/// How well degrees agree with the observed frequencies, as probabilities should.
struct Calibration {
    std::vector<ReliabilityBin> bins;
    double error = 0.0;        ///< expected calibration error
    double temperature = 1.0;  ///< the one that fits the validation part best; 1 if that part has no samples
    double error_at_temperature = 0.0;
};

struct Evaluation {
    Detector detector;
    LabelledSamples samples;
    std::vector<double> scores;  ///< one for each sample
    Performance performance;
    std::optional<Calibration> calibration;  ///< only for detectors that give degrees
    std::vector<PhysicalAgreement> physics;  ///< over the same samples and those with an unknown label
};

Evaluation evaluate(const dataset::Dataset& data, const Detector& detector, const Task& task);

/// The evaluations whose details are worth showing: those of the models, which must come first in the list, or, if
/// there are none, that of the last rule.
std::span<const Evaluation> detailed(std::span<const Evaluation> evaluations);

/// The performance on some of the samples. `places` are positions in evaluation.samples.
Performance performance_at(const Evaluation& evaluation, std::span<const std::size_t> places);

}  // namespace ddtool::judge
