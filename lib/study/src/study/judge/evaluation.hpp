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

/// What detectors are judged on.
struct Task {
    dataset::LabelRule label = dataset::LabelRule::fisher;
    dataset::Split split = dataset::Split::held_out;
    dataset::Part part = dataset::Part::test;
};

/// "fisher / held_out / test".
std::string name_of(const Task& task);

/// How well degrees are probabilities.
struct Calibration {
    std::vector<ReliabilityBin> bins;
    double error = 0.0;        ///< expected calibration error
    double temperature = 1.0;  ///< that fits the part validation best; 1 where it has no samples
    double error_at_temperature = 0.0;
};

struct Evaluation {
    Detector detector;
    LabelledSamples samples;
    std::vector<double> scores;  ///< one a sample
    Performance performance;
    std::optional<Calibration> calibration;  ///< of degrees
    std::vector<PhysicalAgreement> physics;  ///< of the same samples and of those whose label nobody knows
};

Evaluation evaluate(const dataset::Dataset& data, const Detector& detector, const Task& task);

/// Those whose details people want to see: the models, which come first, or else the last of the rules.
std::span<const Evaluation> detailed(std::span<const Evaluation> evaluations);

/// Of some of the samples, by their places among them.
Performance performance_at(const Evaluation& evaluation, std::span<const std::size_t> places);

}  // namespace ddtool::judge
