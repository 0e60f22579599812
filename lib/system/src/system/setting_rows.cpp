#include "system/setting_rows.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

/// A number as people write it: "0.0001", "1", "1000000", but "1e-12" and "4e+18" instead of many zeros.
std::string bare(double number) {
    constexpr double smallest = 1e-5;
    constexpr double largest = 1e15;
    const double size = std::abs(number);
    const bool plain = number == 0.0 || (size >= smallest && size <= largest);
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), number,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    return {text.begin(), end.ptr};
}

std::string with_unit(const std::string& text, const std::string& unit) {
    return unit.empty() ? text : std::string(text).append(" ").append(unit);
}

std::string range_text(const Allowed& allowed) {
    constexpr double endless = 1e18;
    return allowed.most >= endless ? "from " + bare(allowed.least) + " up"
                                   : "from " + bare(allowed.least) + " to " + bare(allowed.most);
}

/// Lists the words; an empty one appears as two quotation marks.
std::string choices_text(const std::vector<std::string>& words) {
    std::vector<std::string> named(words);
    std::replace(named.begin(), named.end(), std::string(), std::string("\"\""));
    return joined(named);
}

bool in_range(const Json& value, const Allowed& allowed) {
    return value.is_number() && value.get<double>() >= allowed.least && value.get<double>() <= allowed.most;
}

bool is_allowed(const Json& value, const Allowed& allowed) {
    switch (allowed.kind) {
        case Allowed::Kind::whole:
            return value.is_number_integer() && in_range(value, allowed);
        case Allowed::Kind::number:
            return in_range(value, allowed);
        case Allowed::Kind::word:
            return value.is_string() && std::find(allowed.words.begin(), allowed.words.end(),
                                                  value.get<std::string>()) != allowed.words.end();
        case Allowed::Kind::text:
            return value.is_string();
        case Allowed::Kind::flag:
            return value.is_boolean();
        case Allowed::Kind::numbers:
            return value.is_array() && (value.empty() || allowed.count == 0 || value.size() == allowed.count) &&
                   std::all_of(value.begin(), value.end(), [&](const Json& each) { return in_range(each, allowed); });
        case Allowed::Kind::other:
            return true;
    }
    return false;
}

std::string joined_path(const std::string& path, const std::string& key) {
    return path.empty() || key.empty() ? path + key : std::string(path).append(".").append(key);
}

}  // namespace

Allowed Allowed::seed() { return whole(0.0, static_cast<double>(std::numeric_limits<std::uint64_t>::max())); }

std::string allowed_text(const Allowed& allowed, const std::string& unit) {
    switch (allowed.kind) {
        case Allowed::Kind::whole:
            return with_unit("a whole number " + range_text(allowed), unit);
        case Allowed::Kind::number:
            return with_unit("a number " + range_text(allowed), unit);
        case Allowed::Kind::word:
            return choices_text(allowed.words);
        case Allowed::Kind::text:
            return "text";
        case Allowed::Kind::flag:
            return "true or false";
        case Allowed::Kind::numbers:
            return allowed.count == 0
                       ? with_unit("a list of numbers", unit) + ", each " + range_text(allowed)
                       : "an empty list or " + with_unit(std::to_string(allowed.count) + " numbers", unit) + ", each " +
                             range_text(allowed);
        case Allowed::Kind::other:
            break;
    }
    return "";
}

void expect_allowed(const Json& value, const Allowed& allowed, const std::string& unit, const std::string& key) {
    if (!is_allowed(value, allowed)) {
        throw UsageError(key + ": expected " + allowed_text(allowed, unit) + ", not " + value.dump());
    }
}

void expect_allowed(const Json& json, const std::vector<Setting>& settings, const std::string& path) {
    for (const Setting& setting : settings) {
        const std::string key = joined_path(path, setting.key);
        if (!setting.key.empty() && !json.contains(setting.key)) {
            throw UsageError(key + ": this setting is missing");
        }
        const Json& value = setting.key.empty() ? json : json.at(setting.key);
        if (setting.group.empty()) {
            expect_allowed(value, setting.allowed, setting.unit, key);
        } else if (!value.is_object()) {
            throw UsageError(key + ": expected an object of settings, not " + value.dump());
        } else {
            expect_allowed(value, setting.group, key);
        }
    }
}

void for_each_setting(const std::vector<Setting>& settings,
                      const std::function<void(const std::string& path, const Setting& setting)>& visit,
                      const std::string& path) {
    for (const Setting& setting : settings) {
        const std::string own = joined_path(path, setting.key);
        if (setting.group.empty()) {
            visit(own, setting);
        } else {
            for_each_setting(setting.group, visit, own);
        }
    }
}

const Json& setting_at(const Json& settings, std::string path) {
    std::replace(path.begin(), path.end(), '.', '/');
    return settings.at(Json::json_pointer("/" + path));
}

std::vector<Setting> without(std::vector<Setting> settings, const std::string& key) {
    std::erase_if(settings, [&](const Setting& setting) { return setting.key == key; });
    for (Setting& setting : settings) {
        if (setting.key.empty()) {  // a group whose settings are on the same level as those around it
            setting.group = without(std::move(setting.group), key);
        }
    }
    return settings;
}

}  // namespace ddtool
