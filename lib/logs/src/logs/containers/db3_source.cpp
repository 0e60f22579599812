#include "logs/containers/db3_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr int wait_for_lock_ms = 5000;

/// Escapes a path for a URI file name of SQLite (https://www.sqlite.org/uri.html).
std::string escaped(const std::string& path) {
    std::string text;
    for (const char c : path) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' || c == '_' || c == '-') {
            text += c;
        } else {
            std::array<char, 4> code{};
            std::snprintf(code.data(), code.size(), "%%%02X", static_cast<unsigned char>(c));
            text += code.data();
        }
    }
    return text;
}

/// A database in WAL mode can be opened in a read-only folder only if it is declared to be immutable. This is allowed
/// if there is no journal beside it.
std::string read_only_uri(const std::filesystem::path& path) {
    const bool has_journal = std::filesystem::exists(path.string() + "-wal");
    return "file:" + escaped(std::filesystem::absolute(path).string()) + (has_journal ? "?mode=ro" : "?immutable=1");
}

std::string column_text(sqlite3_stmt* row, int column) {
    const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
    return text == nullptr ? "" : text;
}

/// SQLite cannot read on.
struct Damaged {
    std::string why;
};

}  // namespace

Db3Source::Db3Source(const std::filesystem::path& path, std::string name, LogProblemHandler on_problem)
    : name_(std::move(name)), on_problem_(std::move(on_problem)), file_(path) {
    const bool has_journal = std::filesystem::exists(path.string() + "-wal");
    if (!has_journal && report_cut()) {
        start_salvage();
        return;
    }
    try {
        open(path);
    } catch (const Damaged& damage) {
        report(damage.why + "; what is left is looked for page by page");
        start_salvage();
    }
}

void Db3Source::open(const std::filesystem::path& path) {
    sqlite3* database = nullptr;
    const int code =
        sqlite3_open_v2(read_only_uri(path).c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    database_.reset(database);
    if (code != SQLITE_OK) {
        throw Error(name_ + ": cannot open: " + sqlite3_errstr(code));
    }
    sqlite3_busy_timeout(database, wait_for_lock_ms);
    read_topics();
    messages_ = prepare("SELECT id, topic_id, timestamp, data FROM messages ORDER BY id");
    const Statement last = prepare("SELECT max(id) FROM messages");
    last_row_ = step(last) ? sqlite3_column_int64(last.get(), 0) : 0;
}

/// Returns whether the file is shorter than its header says.
bool Db3Source::report_cut() {
    const std::uint64_t declared = Db3Pages(file_.bytes()).declared_bytes().value_or(0);
    const std::uint64_t size = file_.bytes().size();
    if (size < declared) {
        report("the file is cut off: " + std::to_string(size) + " of its " + std::to_string(declared) +
                   " bytes are there; its messages are looked for page by page",
               declared - size);
    }
    return size < declared;
}

void Db3Source::start_salvage() {
    messages_.reset();
    salvage_.emplace(file_.bytes());
    if (channels_.empty()) {
        channels_ = salvage_->topics();
    }
    if (channels_.empty()) {
        throw Error(name_ + ": is a damaged SQLite database; no table of topics was found in what is left of it");
    }
}

Db3Source::Statement Db3Source::prepare(const char* query) const {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr);
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_IOERR) {
        throw Damaged{sqlite3_errmsg(database_.get())};
    }
    if (code != SQLITE_OK) {
        throw Error(name_ + ": is no rosbag2 log: " + sqlite3_errmsg(database_.get()) +
                    "; expected an SQLite database with the tables topics and messages");
    }
    return Statement(statement);
}

bool Db3Source::step(const Statement& statement) const {
    const int code = sqlite3_step(statement.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        throw Damaged{sqlite3_errmsg(database_.get())};
    }
    return code == SQLITE_ROW;
}

void Db3Source::read_topics() {
    const Statement topics = prepare("SELECT id, name, type, serialization_format FROM topics");
    while (step(topics)) {
        McapChannel& channel = channels_[sqlite3_column_int64(topics.get(), 0)];
        channel.topic = column_text(topics.get(), 1);
        channel.schema.name = column_text(topics.get(), 2);
        channel.message_encoding = column_text(topics.get(), 3);
    }
}

std::optional<McapMessage> Db3Source::next() {
    while (const std::optional<Db3Salvage::Message> row = next_row()) {
        if (auto message = message_of(*row)) {
            return message;
        }
    }
    return std::nullopt;
}

std::optional<Db3Salvage::Message> Db3Source::next_row() {
    if (!salvage_) {
        try {
            return next_by_order();
        } catch (const Damaged& damage) {
            report("after row " + std::to_string(row_) + ": " + damage.why +
                   "; what follows is looked for page by page");
            start_salvage();
        }
    }
    return next_salvaged();
}

std::optional<Db3Salvage::Message> Db3Source::next_by_order() {
    if (!messages_ || !step(messages_)) {
        messages_.reset();
        return std::nullopt;
    }
    sqlite3_stmt* const row = messages_.get();
    row_ = sqlite3_column_int64(row, 0);
    const auto* const data = static_cast<const std::byte*>(sqlite3_column_blob(row, 3));
    return Db3Salvage::Message{row_,
                               sqlite3_column_int64(row, 1),
                               sqlite3_column_int64(row, 2),
                               {data, static_cast<std::size_t>(sqlite3_column_bytes(row, 3))}};
}

std::optional<Db3Salvage::Message> Db3Source::next_salvaged() {
    const auto message = salvage_->next(row_);
    if (message) {
        lost_rows_ += static_cast<std::uint64_t>(message->id) - static_cast<std::uint64_t>(row_) - 1;
        row_ = message->id;
    } else if (const std::uint64_t lost = std::exchange(lost_rows_, 0); lost > 0) {
        report(std::to_string(lost) + " of the rows up to row " + std::to_string(row_) + " are lost");
    }
    return message;
}

std::optional<McapMessage> Db3Source::message_of(const Db3Salvage::Message& row) {
    const auto channel = channels_.find(row.topic);
    if (channel == channels_.end()) {
        if (undefined_.insert(row.topic).second) {
            report("row " + std::to_string(row.id) + ": topic " + std::to_string(row.topic) +
                   " is not in the table of topics; its messages are skipped");
        }
        return std::nullopt;
    }
    McapMessage message;
    message.channel = &channel->second;
    message.log_time_ns = row.time_ns;
    message.publish_time_ns = row.time_ns;
    message.data = row.data;
    message.file_offset = static_cast<std::uint64_t>(row.id);
    message.offset_unit = "row";
    return message;
}

double Db3Source::fraction_read() const {
    if (salvage_) {
        return salvage_->fraction_read();
    }
    return last_row_ <= 0 ? 1.0 : std::min(1.0, static_cast<double>(row_) / static_cast<double>(last_row_));
}

void Db3Source::report(const std::string& what, std::uint64_t bytes_lost) {
    on_problem_({name_ + ": " + what, 0, bytes_lost});
}

}  // namespace ddtool
