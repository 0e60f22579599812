#include "study/judge/simple_rules.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>

#include "dataset/build_settings.hpp"
#include "scores/decision_threshold.hpp"
#include "study/judge/logistic_regression.hpp"
#include "study/judge/measures.hpp"
#include "study/judge/samples.hpp"

namespace ddtool::judge {
namespace {

std::string short_number(double number) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

/// Sets the detector's threshold. Detectors decide "degenerate" above their threshold, so scores and threshold are
/// negated if the degenerate samples have the lower values.
void decide_by(Detector& detector, const Measure& measure, const DecisionThreshold& threshold) {
    const double sign = threshold.positive_above ? 1.0 : -1.0;
    detector.decision = (threshold.positive_above ? "above " : "below ") + short_number(threshold.value);
    detector.threshold = sign * threshold.value;
    detector.score = one_by_one([sign, value = measure.value](Particles swarm) { return sign * value(swarm); });
}

Detector threshold_rule(const Measure& measure, const dataset::Dataset& data, const LabelledSamples& train) {
    Detector detector;
    detector.name = measure.name;
    detector.swarm = measure.swarm;
    detector.image.swarm = measure.swarm == "step" ? Swarm::step : Swarm::absolute;
    decide_by(detector, measure, {std::numeric_limits<double>::quiet_NaN(), true});
    if (!train.indices.empty()) {
        const std::vector<double> values = scores_of(data, train.indices, detector.score, measure.name);
        decide_by(detector, measure, most_accurate_threshold(values, train.degenerate));
    }
    return detector;
}

Detector regression_rule(const dataset::Dataset& data, const LabelledSamples& train) {
    Eigen::MatrixXd features;
    for (std::size_t place = 0; place < train.indices.size(); ++place) {
        const Eigen::VectorXd row = covariance_features(data.particles(train.indices[place]));
        features.conservativeResize(static_cast<Eigen::Index>(train.indices.size()), row.size());
        features.row(static_cast<Eigen::Index>(place)) = row.transpose();
    }
    const auto regression = std::make_shared<LogisticRegression>(features, train.degenerate);
    Detector detector;
    detector.name = "logistic regression";
    detector.swarm = "both";
    detector.image.swarm = Swarm::step;
    detector.decision = "above 0.5";
    detector.is_degree = true;
    detector.score =
        one_by_one([regression](Particles swarm) { return regression->probability(covariance_features(swarm)); });
    return detector;
}

bool has_both_classes(const LabelledSamples& samples) {
    const auto degenerate = std::count(samples.degenerate.begin(), samples.degenerate.end(), true);
    return degenerate > 0 && degenerate < static_cast<std::ptrdiff_t>(samples.degenerate.size());
}

}  // namespace

std::vector<Detector> fitted_rules(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split) {
    LabelledSamples train = labelled_samples(data, label, split, dataset::Part::train);
    if (!has_both_classes(train)) {
        train = {};
    }
    std::vector<Detector> rules;
    for (const Measure& measure : simple_measures(dataset::assembly_from_json(data.manifest().settings).labels)) {
        rules.push_back(threshold_rule(measure, data, train));
    }
    if (!train.indices.empty()) {
        rules.push_back(regression_rule(data, train));
    }
    for (Detector& rule : rules) {
        rule.label = dataset::label_rule_names[index_of(label)];
        rule.split = dataset::split_names[index_of(split)];
    }
    return rules;
}

}  // namespace ddtool::judge
