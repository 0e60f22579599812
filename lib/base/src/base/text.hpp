#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ddtool {

/// Removes the next word from the front of the line and returns it; returns an empty word at the end of the line. Words
/// are separated by blanks, tabs, commas and carriage returns.
std::string_view next_word(std::string_view& line);

/// The number that the whole word stands for, independent of the locale; nullopt if the word is not a finite number.
std::optional<double> parse_number(std::string_view word);

/// The number with `decimals` digits after the point; "-" for NaN, which stands for a missing number.
std::string fixed_text(double number, int decimals);

/// Decimal seconds, "12.5" or "1.25e+01", as nanoseconds. They are not read as a double, because a double cannot hold
/// nanoseconds since 1970 exactly. Returns nullopt if the word is not a number or does not fit into 64-bit nanoseconds.
std::optional<std::int64_t> parse_stamp(std::string_view word);

}  // namespace ddtool
