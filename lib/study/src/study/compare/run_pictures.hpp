#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "report/figure.hpp"
#include "study/compare/shown_run.hpp"

namespace ddtool::compare {

/// What a figure shows, in metres.
struct Extent {
    plot::Range x;
    plot::Range y;
};

/// Of all trajectories of the run, with a margin.
Extent extent_of(const ShownRun& run);

/// Writes a figure of `panels` axes of the same extent and scale: in columns, or, where what they show is much wider
/// than high (a corridor), one below the other.
void write_side_by_side(const std::filesystem::path& file, const Extent& extent, std::size_t panels,
                        const std::function<void(plot::Axes& axes, std::size_t panel)>& draw);

/// Every estimate over the truth, side by side.
void draw_trajectories(const std::filesystem::path& file, const ShownRun& run);

/// The maps that the truth and the estimates make of the scans, side by side. Reads the data once more.
void draw_maps(const std::filesystem::path& file, const ShownRun& run);

/// |x|, |y| and distance from the truth over time, a line a contestant. There is a truth.
void draw_errors(const std::filesystem::path& file, const ShownRun& run);

}  // namespace ddtool::compare
