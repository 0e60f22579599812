#include "logs/stream/no_return.hpp"

#include <algorithm>
#include <cstddef>

namespace ddtool {
namespace {

constexpr std::size_t least_repeats = 10;
constexpr float top_m = 0.1F;
constexpr float neighbourhood_m = 1.0F;

using Iterator = std::vector<float>::const_iterator;

/// The longest run of equal values in a sorted range.
std::pair<Iterator, Iterator> longest_run(Iterator begin, Iterator end) {
    std::pair<Iterator, Iterator> longest{begin, begin};
    while (begin != end) {
        const auto next = std::upper_bound(begin, end, *begin);
        if (next - begin > longest.second - longest.first) {
            longest = {begin, next};
        }
        begin = next;
    }
    return longest;
}

}  // namespace

std::optional<float> find_no_return_code(std::vector<float> ranges_m) {
    std::sort(ranges_m.begin(), ranges_m.end());
    if (ranges_m.empty()) {
        return std::nullopt;
    }
    const float largest = ranges_m.back();
    const auto from = [&](float below_m) {
        return std::lower_bound(ranges_m.cbegin(), ranges_m.cend(), largest - below_m);
    };
    const auto [code, code_end] = longest_run(from(top_m), ranges_m.cend());
    const auto repeats = static_cast<std::size_t>(code_end - code);
    const auto nearby = static_cast<std::size_t>(ranges_m.cend() - from(neighbourhood_m));
    if (repeats < least_repeats || 2 * repeats <= nearby) {
        return std::nullopt;
    }
    return *code;
}

}  // namespace ddtool
