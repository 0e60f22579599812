#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// The values that a setting may have.
struct Allowed {
    enum class Kind {
        whole,    ///< a whole number from least to most
        number,   ///< a number from least to most
        word,     ///< one of `words`
        text,     ///< any text
        flag,     ///< true or false
        numbers,  ///< a list: empty, or `count` numbers (any count where it is 0), each from least to most
        other,    ///< described only by the setting's sentence; the code that reads it checks it
    };
    Kind kind = Kind::other;
    double least = 0.0;
    double most = 0.0;
    std::vector<std::string> words;
    std::size_t count = 0;

    static Allowed whole(double least, double most) { return {Kind::whole, least, most, {}, 0}; }
    /// 64-bit whole numbers from 0 up, as seeds are.
    static Allowed seed();
    static Allowed number(double least, double most) { return {Kind::number, least, most, {}, 0}; }
    static Allowed one_of(std::vector<std::string> words) { return {Kind::word, 0.0, 0.0, std::move(words), 0}; }
    static Allowed text() { return {Kind::text, 0.0, 0.0, {}, 0}; }
    static Allowed flag() { return {Kind::flag, 0.0, 0.0, {}, 0}; }
    static Allowed numbers(std::size_t count, double least, double most) {
        return {Kind::numbers, least, most, {}, count};
    }
    static Allowed other() { return {}; }
};

/// The description of a setting, without its default: one row of the reference (docs/settings-reference.md).
struct Setting {
    std::string key;  ///< empty for a group whose settings are on the same level as those of its parent
    Allowed allowed;
    std::string unit;            ///< "m", "rad"; empty for a bare number
    std::string meaning;         ///< one whole sentence
    std::string source;          ///< the equation, paper or measurement that it comes from; may be empty
    std::vector<Setting> group;  ///< the settings of a group; a group has a key and settings, and nothing else
};

/// The allowed values as text: "a number from 0.005 to 1 m".
std::string allowed_text(const Allowed& allowed, const std::string& unit);

/// Throws UsageError, "KEY: expected a whole number from 1 to 1000, not 0", unless the value is allowed. NaN never is.
void expect_allowed(const Json& value, const Allowed& allowed, const std::string& unit, const std::string& key);

/// The same for every setting of a JSON object. `path` is put before each key if it is not empty. Keys without a
/// setting are ignored, because merge_settings() has already rejected them.
void expect_allowed(const Json& json, const std::vector<Setting>& settings, const std::string& path);

/// Calls `visit` for every setting that is not a group, in order, with its path, such as "filter.grid.cell_size_m".
void for_each_setting(const std::vector<Setting>& settings,
                      const std::function<void(const std::string& path, const Setting& setting)>& visit,
                      const std::string& path = "");

/// The value at such a path. Throws Json::out_of_range if there is none.
const Json& setting_at(const Json& settings, std::string path);

/// The settings without the one of that key. Settings inside of groups that have a key are kept.
std::vector<Setting> without(std::vector<Setting> settings, const std::string& key);

template <typename Struct>
class SettingTable;

/// One setting of a struct, or a member that is a struct of settings.
template <typename Struct>
struct SettingRow {
    template <typename Value>
    SettingRow(std::string key, Value Struct::*member, Allowed allowed, std::string unit, std::string meaning,
               std::string source = "")
        : setting{std::move(key), std::move(allowed), std::move(unit), std::move(meaning), std::move(source), {}},
          write([name = setting.key, member](Json& json, const Struct& value) { json[name] = value.*member; }),
          read([name = setting.key, member](const Json& json, Struct& value) { json.at(name).get_to(value.*member); }) {
    }

    template <typename Member>
    SettingRow(std::string key, Member Struct::*member, const SettingTable<Member>& rows)
        : setting{std::move(key), {}, "", "", "", rows.settings()},
          write([name = setting.key, member, rows](Json& json, const Struct& value) {
              rows.write(name.empty() ? json : json[name], value.*member);
          }),
          read([name = setting.key, member, rows](const Json& json, Struct& value) {
              rows.read(name.empty() ? json : json.at(name), value.*member);
          }) {}

    /// A member that is a struct, whose settings are on the same level of the JSON as those of this struct.
    template <typename Member>
    SettingRow(Member Struct::*member, const SettingTable<Member>& rows) : SettingRow("", member, rows) {}

    /// A setting whose JSON has another form than its type.
    SettingRow(Setting described, std::function<void(Json&, const Struct&)> writer,
               std::function<void(const Json&, Struct&)> reader)
        : setting(std::move(described)), write(std::move(writer)), read(std::move(reader)) {}

    Setting setting;
    std::function<void(Json& json, const Struct& value)> write;
    std::function<void(const Json& json, Struct& value)> read;
};

/// The settings of a struct, one row for each, in the order of their JSON. All uses of a setting are derived from its
/// row: writing and reading JSON, checking, listings and hints.
template <typename Struct>
class SettingTable {
public:
    SettingTable(std::initializer_list<SettingRow<Struct>> rows) : rows_(rows) {
        for (const SettingRow<Struct>& row : rows_) {
            settings_.push_back(row.setting);
        }
    }

    [[nodiscard]] const std::vector<Setting>& settings() const { return settings_; }

    [[nodiscard]] Json json(const Struct& value) const {
        Json json = Json::object();
        write(json, value);
        return json;
    }

    /// Reads the settings after checking them. Throws UsageError naming the key for a value that is not allowed, with
    /// `path` before the key if it is not empty.
    [[nodiscard]] Struct checked(const Json& json, const std::string& path = "") const {
        expect_allowed(json, settings_, path);
        Struct value;
        read(json, value);
        return value;
    }

    /// Writes the settings into a JSON object.
    void write(Json& json, const Struct& value) const {
        for (const SettingRow<Struct>& row : rows_) {
            row.write(json, value);
        }
    }

    /// Reads the settings without checking whether they are allowed.
    void read(const Json& json, Struct& value) const {
        for (const SettingRow<Struct>& row : rows_) {
            row.read(json, value);
        }
    }

private:
    std::vector<SettingRow<Struct>> rows_;
    std::vector<Setting> settings_;
};

}  // namespace ddtool
