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

/// Parses JSON that comes from outside the program.
/// \param source names the text in messages
/// \param comments whether comments are allowed
/// Throws Json::parse_error, and Error naming `source` if values are nested more than a hundred levels deep, because
/// the functions that copy and print JSON call themselves once per level.
Json parse_json(std::string_view text, const std::string& source, bool comments = false);

/// Puts every value of `changes` into `settings`. Throws UsageError naming `source` and the key for a key that
/// `settings` does not have (with the nearest known keys), and for a value of another type than the setting. The items
/// of a list must have the type of the first item of its default. A setting whose default is null accepts any value.
void merge_settings(Json& settings, const Json& changes, const std::string& source);

/// Reads a JSON file (comments allowed) and merges it. Throws UsageError, also for a file that cannot be read.
void merge_settings_file(Json& settings, const std::filesystem::path& file);

/// Merges one value that is given as text.
/// \param path the keys, separated by dots
/// \param text taken literally if the setting is a string, and parsed as JSON otherwise; a list may be written without
///     its brackets: "0.1,0,0"
/// \param source names the text in messages
/// Throws UsageError as merge_settings() does.
void merge_setting(Json& settings, const std::string& path, const std::string& text, const std::string& source);

/// Merges one "path.to.key=value" of the option --set. Throws UsageError as merge_settings() does.
void merge_assignment(Json& settings, const std::string& assignment);

/// At most three of the known words, nearest first. Distance is the edit distance of the parts after the last dot;
/// where these are equal, that of the whole words.
std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known);

/// The words in one text, separated by commas: "a, b, c".
std::string joined(const std::vector<std::string>& words);

}  // namespace ddtool
