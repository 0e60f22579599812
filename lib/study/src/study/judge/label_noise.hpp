#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "report/table.hpp"

namespace ddtool::judge {

/// A label, and the labels that other runs over the same drive give to the same moment.
struct RepeatedLabel {
    std::string scene;  ///< family of scenes
    bool degenerate = false;
    std::size_t others = 0;  ///< number of other runs that have the moment
    std::size_t others_degenerate = 0;
};

/// The labels of all samples whose moment other runs have, too. Runs are repetitions of each other if they have the
/// same source and scene and differ in nothing but their seeds. The same moment in another run is the sample nearest in
/// time, but no further away than half the usual time between samples of that run. This works because the drive of a
/// world is the same for all seeds, and so is a log.
std::vector<RepeatedLabel> repeated_labels(const dataset::Dataset& data, dataset::LabelRule rule);

/// How often repetitions disagree about a label. Shares are means over the two classes, as if both were equally
/// frequent; they are NaN unless both classes have a repeated label.
struct LabelNoise {
    std::array<std::size_t, 2> samples{};  ///< by class: not degenerate, degenerate
    std::array<double, 2> disagreement{};  ///< by class: how often another run gives the opposite label
    double balanced_disagreement = 0.0;
    /// How often the label equals that of most other runs, where a tie counts one half. This is how well the label can
    /// be predicted by somebody who knows the place and the moment, but not the run.
    double majority_accuracy = 0.0;
};

LabelNoise label_noise(std::span<const RepeatedLabel> labels);

/// The label noise for both label rules, by family of scenes and over all of them.
Table label_noise_table(const dataset::Dataset& data);

}  // namespace ddtool::judge
