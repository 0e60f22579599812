#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ddtool/system/json_whole_numbers.hpp"

namespace ddtool {

/// Settings are plain structs with JSON conversions; their defaults written as JSON are the list of known keys.
/// Keys keep the order of the struct, so an effective configuration reads like the documentation.
using Json = nlohmann::ordered_json;

/// Parses JSON from outside, where `comments` say so with them. Throws Json::parse_error, and Error naming `source` for
/// values nested deeper than a hundred levels: what copies and prints them calls itself for each.
Json parse_json(std::string_view text, const std::string& source, bool comments = false);

/// Puts every value of `changes` into `settings`. Throws UsageError naming `source` and the key for a key that
/// `settings` does not have (with the nearest known ones) or a value of another type; a list's items are of the type of
/// its first default. A setting that is null takes any value.
void merge_settings(Json& settings, const Json& changes, const std::string& source);

/// Reads a JSON file (comments allowed) and merges it. Throws UsageError, also for a file that cannot be read.
void merge_settings_file(Json& settings, const std::filesystem::path& file);

/// Merges one value given as text. The path has dots between keys. The text is taken as it is where the setting is a
/// string; elsewhere it is JSON, and a list may leave out its brackets: "0.1,0,0".
void merge_setting(Json& settings, const std::string& path, const std::string& text, const std::string& source);

/// Merges one "path.to.key=value" of --set.
void merge_assignment(Json& settings, const std::string& assignment);

/// At most three of the known words, nearest first by edit distance: that of the part after the last dot, then of the
/// whole.
std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

}  // namespace ddtool
