#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>

#include "ddtool/system/settings.hpp"

namespace ddtool::jobs {

/// Everything that decides a result, and the id computed from it: equal configurations have equal ids, on every
/// machine.
class Key {
public:
    explicit Key(Json configuration);

    [[nodiscard]] const Json& configuration() const { return configuration_; }
    /// The fingerprint of the configuration, 16 hexadecimal digits.
    [[nodiscard]] const std::string& id() const { return id_; }

private:
    Json configuration_;
    std::string id_;
};

/// How the entries of a store are written.
struct StoreFormat {
    std::string value_key;         ///< the entry is {"configuration": ..., value_key: ...}
    std::string suffix = ".json";  ///< of the entry's file: ID + suffix
    int indent = 2;                ///< of its JSON
};

/// Results in a folder, found by what decides them: an entry is a JSON file that is named by its key's id and holds
/// the whole configuration beside the value. What else belongs to a result lies beside, under the same id, and is
/// written before the entry. Files appear whole or not at all, so that a program that was killed leaves finished
/// results only. Safe to use from many threads, each with keys of its own.
class Store {
public:
    /// The folder need not exist as long as results are only looked up.
    Store(std::filesystem::path folder, StoreFormat format) : folder_(std::move(folder)), format_(std::move(format)) {}

    /// What `read` makes of the stored value. Nullopt where there is no entry, and, after a warning that names the
    /// file, where it is damaged: it cannot be read, it is of another configuration, or `read` throws, which it should
    /// also do where what lies beside the entry is damaged or missing.
    template <typename Read>
    [[nodiscard]] auto find(const Key& key, const Read& read) const
        -> std::optional<std::invoke_result_t<Read, const Json&>> {
        if (!has_entry(key)) {
            return std::nullopt;
        }
        try {
            return read(value_of(key));
        } catch (const std::exception& damage) {
            tell_of(damage, key);
            return std::nullopt;
        }
    }
    /// Writes the entry and replaces an older one. Throws OutputError if it cannot be written.
    void save(const Key& key, const Json& value) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// FOLDER/ID + suffix, for what lies beside the entry.
    [[nodiscard]] std::filesystem::path file(const Key& key, const std::string& suffix) const;

private:
    [[nodiscard]] bool has_entry(const Key& key) const;
    [[nodiscard]] Json value_of(const Key& key) const;
    void tell_of(const std::exception& damage, const Key& key) const;

    std::filesystem::path folder_;
    StoreFormat format_;
};

}  // namespace ddtool::jobs
