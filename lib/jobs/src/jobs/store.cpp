#include "jobs/store.hpp"

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/fingerprint.hpp"
#include "system/log.hpp"

namespace ddtool::jobs {

Key::Key(Json configuration)
    : configuration_(std::move(configuration)), id_(Fingerprint().add(configuration_.dump()).hex()) {}

void Store::save(const Key& key, const Json& value) const {
    const Json entry{{"configuration", key.configuration()}, {format_.value_key, value}};
    write_file(file(key, format_.suffix), entry.dump(format_.indent) + "\n");
}

std::filesystem::path Store::file(const Key& key, const std::string& suffix) const {
    return folder_ / (key.id() + suffix);
}

bool Store::has_entry(const Key& key) const { return std::filesystem::exists(file(key, format_.suffix)); }

Json Store::value_of(const Key& key) const {
    const std::filesystem::path path = file(key, format_.suffix);
    const Json entry = parse_json(read_file(path), path.string());
    if (entry.at("configuration") != key.configuration()) {
        throw Error("it is of another configuration than the one that its name stands for");
    }
    return entry.at(format_.value_key);
}

void Store::tell_of(const std::exception& damage, const Key& key) const {
    const std::string path = file(key, format_.suffix).string();
    const std::string text = failure_text(damage);
    const bool names_it = text.starts_with(path + ": ");
    log_warning(path + ": damaged, so it counts as missing: " + (names_it ? text.substr(path.size() + 2) : text));
}

}  // namespace ddtool::jobs
