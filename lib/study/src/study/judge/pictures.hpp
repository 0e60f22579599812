#pragma once

#include <filesystem>
#include <span>

#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// Draws into the folder, of evaluations that have samples:
/// roc.png         the receiver operating characteristic of the models and the best rules, seven in all
/// reliability.png what degrees said against what was so, of the detectors that give degrees
/// confusion.png   counts and shares of right and wrong decisions of every detector
/// particles.png   accuracy over the number of particles, of the same
/// mistakes.png    the most wrong decisions of `shown`, as it sees them
void draw_evaluations(const std::filesystem::path& folder, const dataset::Dataset& data,
                      std::span<const Evaluation> evaluations, const Evaluation& shown);

}  // namespace ddtool::judge
