#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ddtool {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
constexpr std::string_view separators = " \t\r,";

}  // namespace

std::string_view next_word(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(separators), line.size());
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::optional<double> parse_number(std::string_view word) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
    if (error != std::errc() || end != word.end() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> parse_stamp(std::string_view word) {
    std::int64_t seconds = 0;
    const auto [end, error] = std::from_chars(word.begin(), word.end(), seconds);
    if (error != std::errc() || seconds > 9'000'000'000 || seconds < -9'000'000'000) {
        return std::nullopt;
    }
    double fraction = 0.0;
    if (end != word.end()) {
        const auto [last, fraction_error] = std::from_chars(end, word.end(), fraction);
        if (fraction_error != std::errc() || last != word.end() || !(std::abs(fraction) < 1.0)) {
            return std::nullopt;
        }
    }
    const auto fraction_ns = static_cast<std::int64_t>(std::llround(fraction * 1e9));
    return seconds * ns_per_s + (word.front() == '-' ? -fraction_ns : fraction_ns);
}

}  // namespace ddtool
