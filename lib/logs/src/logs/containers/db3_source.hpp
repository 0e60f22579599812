#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/db3_salvage.hpp"
#include "logs/containers/message_source.hpp"
#include "system/mapped_file.hpp"

namespace ddtool {

/// The messages of rosbag2's SQLite storage (.db3) in the order in which they were stored, from the tables `topics`
/// (id, name, type, serialization_format) and `messages` (id, topic_id, timestamp in ns, data). The database is opened
/// read only. If it was not closed, its journal is read as well. If it is cut off or damaged, what is left is looked
/// for page by page, and what is missing is reported.
class Db3Source : public MessageSource {
public:
    /// \param name stands for the file in messages
    /// Throws Error naming the file if it cannot be opened or does not have these tables.
    Db3Source(const std::filesystem::path& path, std::string name, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override;

private:
    struct Close {
        void operator()(sqlite3* database) const { sqlite3_close(database); }
        void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
    };
    using Statement = std::unique_ptr<sqlite3_stmt, Close>;

    [[nodiscard]] Statement prepare(const char* query) const;
    void open(const std::filesystem::path& path);
    /// Advances to the next row; returns whether there is one. Throws Damaged if SQLite cannot read it.
    [[nodiscard]] bool step(const Statement& statement) const;
    void read_topics();
    bool report_cut();
    void start_salvage();
    /// The next row that is a message, whatever its topic; nullopt at the end.
    std::optional<Db3Salvage::Message> next_row();
    std::optional<Db3Salvage::Message> next_by_order();
    std::optional<Db3Salvage::Message> next_salvaged();
    std::optional<McapMessage> message_of(const Db3Salvage::Message& row);
    void report(const std::string& what, std::uint64_t bytes_lost = 0);

    std::string name_;
    LogProblemHandler on_problem_;
    MappedFile file_;
    std::unique_ptr<sqlite3, Close> database_;
    Statement messages_;  // declared after database_, so that it is finalised before the database is closed
    std::optional<Db3Salvage> salvage_;  ///< once SQLite cannot go on
    std::uint64_t lost_rows_ = 0;        ///< whose ids are missing between those that were salvaged
    std::map<std::int64_t, McapChannel> channels_;
    std::set<std::int64_t> undefined_;
    std::int64_t row_ = 0;
    std::int64_t last_row_ = 0;
};

}  // namespace ddtool
