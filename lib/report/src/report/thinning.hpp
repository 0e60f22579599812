#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ddtool::html {

/// Rows that show what all rows would in a picture: where the lines are longer than `most` rows they are cut into
/// stretches, and of each stretch its first row stays and, for every line, the rows of its least and largest value.
/// All lines have the same number of rows; NaN is neither least nor largest. Rising; the first and the last row are
/// among them. `most` holds where it is at least 2 + 2 * lines.
std::vector<std::size_t> telling_rows(std::span<const std::vector<double>> lines, std::size_t most);

}  // namespace ddtool::html
