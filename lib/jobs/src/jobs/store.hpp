#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>

#include "ddtool/system/settings.hpp"

namespace ddtool::jobs {

/// Everything that a result depends on, and an id computed from it. Equal configurations have equal ids on every
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

/// Stores results in a folder under what they depend on. An entry is a JSON file, named by the id of its key, that
/// contains the whole configuration and the value. Other files that belong to a result have the same id in their names
/// and are written before the entry. A file appears only when it is complete, so a program that was killed leaves
/// finished results only. May be used by many threads at the same time if they use different keys.
class Store {
public:
    /// The folder need not exist as long as results are only looked up.
    Store(std::filesystem::path folder, StoreFormat format) : folder_(std::move(folder)), format_(std::move(format)) {}

    /// Returns what `read` returns for the stored value. Returns nullopt if there is no entry. Also returns nullopt,
    /// after a warning that names the file, if the entry is damaged: it cannot be read, it belongs to another
    /// configuration, or `read` throws. `read` should throw if a file that belongs to the entry is damaged or missing.
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
    /// Writes the entry, replacing an older one. Throws OutputError if it cannot be written.
    void save(const Key& key, const Json& value) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// The path FOLDER/ID + suffix of another file that belongs to the entry.
    [[nodiscard]] std::filesystem::path file(const Key& key, const std::string& suffix) const;

private:
    [[nodiscard]] bool has_entry(const Key& key) const;
    [[nodiscard]] Json value_of(const Key& key) const;
    void tell_of(const std::exception& damage, const Key& key) const;

    std::filesystem::path folder_;
    StoreFormat format_;
};

}  // namespace ddtool::jobs
