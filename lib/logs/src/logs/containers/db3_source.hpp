#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of rosbag2's SQLite storage (.db3) in the order in which they were stored, from the tables `topics`
/// (id, name, type, serialization_format) and `messages` (id, topic_id, timestamp in ns, data). The database is opened
/// read only. If it was not closed, its journal is read as well.
class Db3Source : public MessageSource {
public:
    /// Throws Error naming the file if it cannot be opened or does not have these tables.
    Db3Source(const std::filesystem::path& path, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override;

private:
    struct Close {
        void operator()(sqlite3* database) const { sqlite3_close(database); }
        void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
    };
    using Statement = std::unique_ptr<sqlite3_stmt, Close>;

    [[nodiscard]] Statement prepare(const char* query) const;
    /// Advances to the next row; returns whether there is one.
    bool step(const Statement& statement);
    void read_topics();
    std::optional<McapMessage> take_row();
    void report(const std::string& what);

    std::string name_;
    LogProblemHandler on_problem_;
    std::unique_ptr<sqlite3, Close> database_;
    Statement messages_;  // declared after database_, so that it is finalised before the database is closed
    std::map<std::int64_t, McapChannel> channels_;
    std::set<std::int64_t> undefined_;
    std::int64_t row_ = 0;
    std::int64_t last_row_ = 0;
};

}  // namespace ddtool
