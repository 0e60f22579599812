#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"

namespace ddtool::dataset {

/// Draws dispersion.png and fisher.png into the folder: for each family of scenes a histogram of what the label rule
/// looks at, R or the physical ratio, on a logarithmic axis, and the share of samples that it calls degenerate.
void draw_histograms(const std::filesystem::path& folder, const Dataset& data);

}  // namespace ddtool::dataset
