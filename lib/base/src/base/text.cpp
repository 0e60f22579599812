#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace ddtool {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
/// The largest stamp in seconds; 64-bit nanoseconds reach up to 9.2e9 s.
constexpr std::int64_t longest_s = 9'000'000'000;
constexpr std::string_view separators = " \t\r,";

/// Parses a stamp in scientific notation, the form in which numpy.savetxt, and with it evo, writes stamps. A long
/// double is used because its mantissa, which has 64 bits on x86, holds nanoseconds since 1970; that of a double does
/// not.
std::optional<std::int64_t> parse_scientific_stamp(std::string_view word) {
    long double seconds = 0.0L;
    const auto [end, error] = std::from_chars(word.begin(), word.end(), seconds);
    if (error != std::errc() || end != word.end() || !(std::abs(seconds) <= static_cast<long double>(longest_s))) {
        return std::nullopt;
    }
    return static_cast<std::int64_t>(std::llround(seconds * static_cast<long double>(ns_per_s)));
}

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

std::string fixed_text(double number, int decimals) {
    if (std::isnan(number)) {
        return "-";
    }
    const int length = std::snprintf(nullptr, 0, "%.*f", decimals, number);
    std::string text(static_cast<std::size_t>(length), '\0');
    std::snprintf(text.data(), text.size() + 1, "%.*f", decimals, number);
    return text;
}

std::optional<std::int64_t> parse_stamp(std::string_view word) {
    if (word.find_first_of("eE") != std::string_view::npos) {
        return parse_scientific_stamp(word);
    }
    std::int64_t seconds = 0;
    const auto [end, error] = std::from_chars(word.begin(), word.end(), seconds);
    if (error != std::errc() || seconds > longest_s || seconds < -longest_s || (end != word.end() && *end != '.')) {
        return std::nullopt;
    }
    double fraction = 0.0;
    if (end != word.end()) {
        const auto [last, fraction_error] = std::from_chars(end, word.end(), fraction);
        if (fraction_error != std::errc() || last != word.end()) {
            return std::nullopt;
        }
    }
    const auto fraction_ns = static_cast<std::int64_t>(std::llround(fraction * 1e9));
    return seconds * ns_per_s + (word.front() == '-' ? -fraction_ns : fraction_ns);
}

}  // namespace ddtool
