#include "report/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

namespace ddtool::report {
namespace {

/// The row of [begin, end) whose value comes first in the order `before`. NaN values are passed over; if all values are
/// NaN, the result is `begin`.
template <typename Before>
std::size_t extreme_row(const std::vector<double>& line, std::size_t begin, std::size_t end, Before before) {
    std::size_t found = begin;
    for (std::size_t row = begin; row < end; ++row) {
        if (!std::isnan(line[row]) && (std::isnan(line[found]) || before(line[row], line[found]))) {
            found = row;
        }
    }
    return found;
}

}  // namespace

std::vector<std::size_t> telling_rows(std::span<const std::vector<double>> lines, std::size_t most) {
    const std::size_t rows = lines.empty() ? 0 : lines.front().size();
    if (rows <= most) {
        std::vector<std::size_t> all(rows);
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    const std::size_t of_stretch = 1 + 2 * lines.size();
    const std::size_t stretches = std::max<std::size_t>(1, (std::max<std::size_t>(most, 1) - 1) / of_stretch);
    std::set<std::size_t> kept{rows - 1};
    for (std::size_t stretch = 0; stretch < stretches; ++stretch) {
        const std::size_t begin = stretch * rows / stretches;
        const std::size_t end = (stretch + 1) * rows / stretches;
        kept.insert(begin);
        for (const std::vector<double>& line : lines) {
            kept.insert(extreme_row(line, begin, end, std::less<>()));
            kept.insert(extreme_row(line, begin, end, std::greater<>()));
        }
    }
    return {kept.begin(), kept.end()};
}

}  // namespace ddtool::report
