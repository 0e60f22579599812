#pragma once

#include <cstddef>
#include <vector>

#include "dataset/dataset.hpp"

namespace ddtool::detection {

/// Positions of samples in a data set, and what their label says.
struct LabelledSamples {
    std::vector<std::size_t> indices;
    std::vector<bool> degenerate;
};

inline LabelledSamples labelled_samples(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split,
                                        dataset::Part part) {
    LabelledSamples samples{data.part(label, split, part), {}};
    for (const std::size_t index : samples.indices) {
        samples.degenerate.push_back(data.sample(index).label_of(label) == dataset::Label::degenerate);
    }
    return samples;
}

}  // namespace ddtool::detection
