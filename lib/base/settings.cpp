#include "base/settings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace ddtool {
namespace {

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

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

bool same_type(const Json& known, const Json& value) {
    if (known.is_number_float()) {
        return value.is_number();
    }
    if (known.is_number_integer()) {
        return value.is_number_integer() && (!known.is_number_unsigned() || value >= 0);
    }
    return known.is_null() || known.type() == value.type();
}

void merge(Json& settings, const Json& changes, const std::string& source, const std::string& prefix) {
    for (const auto& [key, value] : changes.items()) {
        const std::string path = prefix + key;
        if (!settings.contains(key)) {
            std::vector<std::string> known;
            for (const auto& item : settings.items()) {
                known.push_back(item.key());
            }
            throw UsageError(source + ": unknown setting '" + path +
                             "'; did you mean: " + joined(nearest_words(key, known)) + "?");
        }
        Json& target = settings[key];
        if (target.is_object() && value.is_object()) {
            merge(target, value, source, path + ".");
        } else if (same_type(target, value)) {
            target = value;
        } else {
            throw UsageError(source + ": setting '" + path + "' is " + value.dump() + ", expected a " +
                             target.type_name() + " such as " + target.dump());
        }
    }
}

Json parse_value(const std::string& text) {
    Json value = Json::parse(text, nullptr, false);
    return value.is_discarded() ? Json(text) : value;
}

}  // namespace

std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known) {
    std::vector<std::string> words = known;
    std::stable_sort(words.begin(), words.end(), [&](const std::string& a, const std::string& b) {
        return edit_distance(word, a) < edit_distance(word, b);
    });
    words.resize(std::min<std::size_t>(words.size(), 3));
    return words;
}

void merge_settings(Json& settings, const Json& changes, const std::string& source) {
    if (!changes.is_object()) {
        throw UsageError(source + ": expected a JSON object of settings");
    }
    merge(settings, changes, source, "");
}

void merge_settings_file(Json& settings, const std::filesystem::path& file) {
    const std::string text = read_file(file);
    Json changes;
    try {
        changes = Json::parse(text, nullptr, true, true);
    } catch (const Json::parse_error& error) {
        throw UsageError(file.string() + ": not JSON at byte " + std::to_string(error.byte));
    }
    merge_settings(settings, changes, file.string());
}

void merge_setting(Json& settings, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        throw UsageError("--set " + assignment + ": expected path.to.key=value");
    }
    std::string pointer = "/" + assignment.substr(0, equals);
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    Json changes;
    changes[Json::json_pointer(pointer)] = parse_value(assignment.substr(equals + 1));
    merge_settings(settings, changes, "--set");
}

}  // namespace ddtool
