#pragma once

#include <filesystem>

#include "study/compare/shown_run.hpp"

namespace ddtool::compare {

/// Every estimate over the truth, side by side.
void draw_trajectories(const std::filesystem::path& file, const ShownRun& run);

/// The maps that the truth and the estimates make of the scans, side by side. Reads the data once more.
void draw_maps(const std::filesystem::path& file, const ShownRun& run);

/// |x|, |y| and distance from the truth over time, a line a method. There is a truth.
void draw_errors(const std::filesystem::path& file, const ShownRun& run);

}  // namespace ddtool::compare
