#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "report/table.hpp"

namespace ddtool::judge {

/// A label, and those that other runs over the same drive give the same moment.
struct RepeatedLabel {
    std::string scene;  ///< family
    bool degenerate = false;
    std::size_t others = 0;  ///< runs that have the moment, this one not counted
    std::size_t others_degenerate = 0;
};

/// The labels of all samples whose moment other runs have, too. Runs are repetitions when they are of the same source
/// and scene and differ in nothing but their seeds. The same moment is the nearest in time, no further than half the
/// usual time between samples of the other run: drives of a world are the same for all seeds, and so are logs.
std::vector<RepeatedLabel> repeated_labels(const dataset::Dataset& data, dataset::LabelRule rule);

/// How often a label disagrees with itself. Shares are means over the two classes, as if both were equally frequent;
/// NaN without a repeated label of both.
struct LabelNoise {
    std::array<std::size_t, 2> samples{};  ///< by class: not degenerate, degenerate
    std::array<double, 2> disagreement{};  ///< by class: how often one other run gives the other label
    double balanced_disagreement = 0.0;
    /// How often the label is what most other runs say, a tie counting one half: what can be known of the label by one
    /// who knows the place and the moment, but not the run.
    double majority_accuracy = 0.0;
};

LabelNoise label_noise(std::span<const RepeatedLabel> labels);

/// Of both label rules: by family of scenes, and of them all.
Table label_noise_table(const dataset::Dataset& data);

}  // namespace ddtool::judge
