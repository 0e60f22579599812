#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ddtool {

/// Settings are plain structs with JSON conversions; their defaults written as JSON are the list of known keys.
/// Keys keep the order of the struct, so an effective configuration reads like the documentation.
using Json = nlohmann::ordered_json;

/// Puts every value of `changes` into `settings`. Throws UsageError naming `source` and the key for a key that
/// `settings` does not have (with the nearest known ones) or a value of another type.
void merge_settings(Json& settings, const Json& changes, const std::string& source);

/// Reads a JSON file (comments allowed) and merges it.
void merge_settings_file(Json& settings, const std::filesystem::path& file);

/// Merges one "path.to.key=value"; the value is JSON, or a bare string where the setting is a string.
void merge_setting(Json& settings, const std::string& assignment);

/// Known words at the smallest edit distance from `word`, at most three, nearest first.
std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known);

}  // namespace ddtool
