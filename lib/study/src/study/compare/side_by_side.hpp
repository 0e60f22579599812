#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "report/figure.hpp"

namespace ddtool::compare {

/// What a figure shows, in metres.
struct Extent {
    plot::Range x;
    plot::Range y;
};

/// Writes a figure of `panels` axes of the same extent and scale: in columns, or, where what they show is much wider
/// than high (a corridor), one below the other.
void write_side_by_side(const std::filesystem::path& file, const Extent& extent, std::size_t panels,
                        const std::function<void(plot::Axes& axes, std::size_t panel)>& draw);

}  // namespace ddtool::compare
