#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "report/figure.hpp"
#include "study/compare/shown_run.hpp"

namespace ddtool::compare {

/// The area that a figure shows, in metres.
struct Extent {
    report::Range x;
    report::Range y;
};

/// The extent of all trajectories of the run, with a margin.
Extent extent_of(const ShownRun& run);

/// Writes a figure of `panels` axes with the same extent and scale: side by side, or one below the other if the extent
/// is much wider than high (a corridor). `draw` fills each of them.
void write_side_by_side(const std::filesystem::path& file, const Extent& extent, std::size_t panels,
                        const std::function<void(report::Axes& axes, std::size_t panel)>& draw);

/// Draws every estimate over the true trajectory, side by side.
void draw_trajectories(const std::filesystem::path& file, const ShownRun& run);

/// Draws the maps that result from the scans with the true trajectory and with each estimate, side by side. Reads the
/// data once more.
void draw_maps(const std::filesystem::path& file, const ShownRun& run);

/// Draws the errors |x|, |y| and the distance from the truth over time, one line for each contestant. The run must have
/// a true trajectory.
void draw_errors(const std::filesystem::path& file, const ShownRun& run);

}  // namespace ddtool::compare
