#include "ddtool/system/settings.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

constexpr int most_levels = 100;

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({substituted, row[j] + 1, row[j - 1] + 1}));
        }
    }
    return row.back();
}

void collect_paths(const Json& settings, const std::string& prefix, std::vector<std::string>& paths) {
    for (const auto& [key, value] : settings.items()) {
        paths.push_back(prefix + key);
        collect_paths(value.is_object() ? value : Json::object(), prefix + key + ".", paths);
    }
}

/// Suggests similar ones of all known paths, not only of the same group, because besides typing errors the usual
/// mistake is the wrong group.
[[noreturn]] void fail_unknown(const Json& all, const std::string& path, const std::string& source) {
    std::vector<std::string> known;
    collect_paths(all, "", known);
    const std::string hint =
        known.empty() ? "there are no settings" : "did you mean: " + joined(nearest_words(path, known)) + "?";
    throw UsageError(source + ": unknown setting '" + path + "'; " + hint);
}

bool fits(const Json& known, const Json& value) {
    if (known.is_null()) {
        return true;
    }
    if (known.is_number_float()) {
        return value.is_number();
    }
    if (known.is_number_integer()) {
        return value.is_number_integer() && (!known.is_number_unsigned() || value.is_number_unsigned() || value >= 0);
    }
    if (known.is_array() && value.is_array() && !known.empty()) {
        return std::all_of(value.begin(), value.end(), [&](const Json& item) { return fits(known.front(), item); });
    }
    return known.type() == value.type();
}

std::string kind_of(const Json& known) {
    if (known.is_number_unsigned()) {
        return "whole number from 0 up";
    }
    return known.is_number_integer() ? "whole number" : known.type_name();
}

std::string expectation_from(const Json& known) {
    if (known.is_array() && known.empty()) {
        return "values separated by commas";
    }
    return kind_of(known) + " such as " + known.dump();
}

struct Merge {
    const std::string& source;
    const Json& all;  ///< all known settings, for hints in messages

    void operator()(Json& settings, const Json& changes, const std::string& prefix) const {
        for (const auto& [key, value] : changes.items()) {
            const std::string path = prefix + key;
            if (!settings.contains(key)) {
                fail_unknown(all, path, source);
            }
            replace(settings[key], value, path);
        }
    }

    void replace(Json& known, const Json& value, const std::string& path) const {
        if (known.is_object() && value.is_object()) {
            (*this)(known, value, path + ".");
        } else if (!known.is_object() && fits(known, value)) {
            // A setting that is a float stays one; otherwise "1" would turn it into a whole number that then rejects
            // 0.5.
            known = known.is_number_float() ? Json(value.get<double>()) : value;
        } else {
            throw UsageError(source + ": setting '" + path + "' is " + value.dump() + ", expected " +
                             expectation_from(known));
        }
    }
};

/// The value at the path given by the keys; null if there is none.
const Json* find_setting(const Json& settings, const std::vector<std::string>& keys) {
    const Json* found = &settings;
    for (const std::string& key : keys) {
        if (!found->is_object() || !found->contains(key)) {
            return nullptr;
        }
        found = &(*found)[key];
    }
    return found;
}

std::vector<std::string> split_path(const std::string& path) {
    std::vector<std::string> keys;
    std::istringstream stream(path);
    for (std::string key; std::getline(stream, key, '.');) {
        keys.push_back(key);
    }
    return keys;
}

Json parse_value(const Json* known, const std::string& text) {
    if (known != nullptr && known->is_string()) {
        return text;
    }
    Json value = Json::parse(text, nullptr, false);
    const bool is_list = known != nullptr && known->is_array();
    if (is_list && (value.is_discarded() || value.is_number())) {
        value = Json::parse("[" + text + "]", nullptr, false);
    }
    return value.is_discarded() ? Json(text) : value;
}

std::size_t line_of(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace

Json parse_json(std::string_view text, const std::string& source, bool comments) {
    const auto expect_shallow = [&](int depth, Json::parse_event_t /*event*/, const Json& /*value*/) {
        if (depth > most_levels) {
            throw Error(source + ": nested deeper than " + std::to_string(most_levels) + " levels");
        }
        return true;
    };
    return Json::parse(text, expect_shallow, true, comments);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known) {
    const auto last_part = [](const std::string& path) { return path.substr(path.find_last_of('.') + 1); };
    constexpr std::size_t longest = 100;  // no real name is longer, and the time grows with the length
    const std::string start = word.substr(0, longest);
    using Distance = std::pair<std::size_t, std::size_t>;
    std::vector<std::pair<Distance, std::string>> nearest;
    for (const std::string& each : known) {
        nearest.emplace_back(Distance(edit_distance(last_part(start), last_part(each)), edit_distance(start, each)),
                             each);
    }
    std::stable_sort(nearest.begin(), nearest.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> words;
    for (std::size_t place = 0; place < std::min<std::size_t>(nearest.size(), 3); ++place) {
        words.push_back(nearest[place].second);
    }
    return words;
}

void merge_settings(Json& settings, const Json& changes, const std::string& source) {
    if (!changes.is_object()) {
        throw UsageError(source + ": expected a JSON object of settings");
    }
    const Json all = settings;
    Merge{source, all}(settings, changes, "");
}

void merge_settings_file(Json& settings, const std::filesystem::path& file) {
    std::string text;
    Json changes;
    try {
        text = read_file(file);
        changes = parse_json(text, file.string(), /*comments=*/true);
    } catch (const Json::parse_error& error) {
        throw UsageError(file.string() + ":" + std::to_string(line_of(text, error.byte)) + ": expected JSON");
    } catch (const Error& error) {
        throw UsageError(error.what());
    }
    merge_settings(settings, changes, file.string());
}

void merge_setting(Json& settings, const std::string& path, const std::string& text, const std::string& source) {
    const std::vector<std::string> keys = split_path(path);
    Json changes = parse_value(find_setting(settings, keys), text);
    std::for_each(keys.rbegin(), keys.rend(), [&](const auto& key) { changes = Json::object({{key, changes}}); });
    merge_settings(settings, changes, source);
}

void merge_assignment(Json& settings, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == 0 || equals == std::string::npos) {
        throw UsageError("--set " + assignment + ": expected path.to.key=value");
    }
    merge_setting(settings, assignment.substr(0, equals), assignment.substr(equals + 1), "--set");
}

}  // namespace ddtool
