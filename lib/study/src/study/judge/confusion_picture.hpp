#pragma once

#include <filesystem>
#include <span>

#include "study/judge/evaluation.hpp"

namespace ddtool::detection {

/// A square of four fields for every detector that decides: what was so downwards, what was decided rightwards; the
/// darker, the larger the share of what was so.
void draw_confusions(const std::filesystem::path& file, std::span<const Evaluation> evaluations);

}  // namespace ddtool::detection
