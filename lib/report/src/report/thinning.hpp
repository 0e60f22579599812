#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ddtool::report {

/// Chooses rows that show in a picture what all rows would. If the lines have more than `most` rows, they are divided
/// into stretches; of each stretch, its first row is kept and, for every line, the rows with its smallest and its
/// largest value. All lines must have the same number of rows; NaN is never the smallest or the largest value. The
/// result rises and contains the first and the last row. It has at most `most` rows if `most` is at least 2 + 2 *
/// lines.
std::vector<std::size_t> telling_rows(std::span<const std::vector<double>> lines, std::size_t most);

}  // namespace ddtool::report
