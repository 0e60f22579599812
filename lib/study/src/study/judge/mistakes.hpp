#pragma once

#include <filesystem>
#include <vector>

#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// Positions in evaluation.samples of the samples of a class that were decided wrongly, the most wrong first. Empty for
/// a detector without a threshold.
std::vector<std::size_t> mistakes_of(const Evaluation& evaluation, bool degenerate);

/// Draws a montage of the worst misses and false alarms of each family of scenes, as the detector sees them.
void draw_mistakes(const std::filesystem::path& file, const dataset::Dataset& data, const Evaluation& evaluation);

}  // namespace ddtool::judge
