#pragma once

#include <filesystem>
#include <vector>

#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// Places of the wrongly decided samples of a class among those of the evaluation, the most wrong first. None for a
/// detector without threshold.
std::vector<std::size_t> mistakes_of(const Evaluation& evaluation, bool degenerate);

/// A montage: for each family of scenes the worst misses and false alarms, as the detector sees them.
void draw_mistakes(const std::filesystem::path& file, const dataset::Dataset& data, const Evaluation& evaluation);

}  // namespace ddtool::judge
