#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ddtool {

/// Throws UsageError naming the key unless least <= value <= most. NaN is always rejected.
void expect_between(const std::string& key, double value, double least, double most);

/// Returns the position of the word in the list of known words. Throws UsageError naming the key and all known words if
/// it is not in the list.
std::size_t expect_one_of(const std::string& key, const std::string& word, std::span<const char* const> known);

}  // namespace ddtool
