#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ddtool {

/// Takes the next word off the front of a line; words are parted by blanks, tabs, commas and carriage returns.
/// Empty at the end of the line.
std::string_view next_word(std::string_view& line);

/// The whole word as a finite number, independent of the locale; none otherwise.
std::optional<double> parse_number(std::string_view word);

/// With that many digits after the point; "-" for NaN, a number that is missing.
std::string fixed_text(double number, int decimals);

/// Decimal seconds, "12.5" or "1.25e+01", as nanoseconds: a double has no room for nanoseconds since 1970. None for
/// what is not a number or beyond the years of a 64-bit nanosecond clock.
std::optional<std::int64_t> parse_stamp(std::string_view word);

}  // namespace ddtool
