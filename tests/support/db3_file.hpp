#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

#include "logs/containers/compression.hpp"
#include "recording.hpp"

namespace ddtool::test {

/// An SQLite database, which is created if it does not exist.
class Database {
public:
    explicit Database(const std::filesystem::path& path) {
        sqlite3_open(path.c_str(), &database_);
        run("PRAGMA synchronous = OFF");
    }
    ~Database() { sqlite3_close(database_); }
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Runs the statement. `blob` is the value of its parameter, if it has one.
    void run(const std::string& statement, std::span<const std::byte> blob = {}) {
        sqlite3_stmt* prepared = nullptr;
        sqlite3_prepare_v2(database_, statement.c_str(), -1, &prepared, nullptr);
        sqlite3_bind_blob64(prepared, 1, blob.data(), blob.size(), SQLITE_TRANSIENT);
        const int code = sqlite3_step(prepared);
        sqlite3_finalize(prepared);
        if (code != SQLITE_DONE && code != SQLITE_ROW) {
            throw std::runtime_error(statement + ": " + sqlite3_errmsg(database_));
        }
    }

private:
    sqlite3* database_ = nullptr;
};

/// Writes the tables of rosbag2 (rosbag2_storage_sqlite3). With `packed`, each message is compressed.
inline void write_db3(const std::filesystem::path& path, std::span<const RecordedMessage> recording,
                      Compression packed = Compression::none) {
    Database database(path);
    database.run(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
    database.run(
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
        "NULL, data BLOB NOT NULL)");
    database.run("BEGIN");
    std::map<std::string, std::size_t> topics;
    for (const RecordedMessage& message : recording) {
        const auto [topic, is_new] = topics.try_emplace(message.topic, topics.size() + 1);
        const std::string id = std::to_string(topic->second);
        if (is_new) {
            database.run("INSERT INTO topics VALUES(" + id + ", '" + message.topic + "', '" + message.ros2_type +
                         "', 'cdr', '')");
        }
        database.run("INSERT INTO messages(topic_id, timestamp, data) VALUES(" + id + ", " +
                         std::to_string(message.stamp_ns) + ", ?)",
                     compress(packed, message.cdr));
    }
    database.run("COMMIT");
}

}  // namespace ddtool::test
