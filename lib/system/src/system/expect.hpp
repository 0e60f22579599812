#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ddtool {

/// Throws UsageError naming the key unless least <= value <= most; NaN is never between.
void expect_between(const std::string& key, double value, double least, double most);

/// The position of the word among the known ones. Throws UsageError naming the key and all of them for another word.
std::size_t expect_one_of(const std::string& key, const std::string& word, std::span<const char* const> known);

}  // namespace ddtool
