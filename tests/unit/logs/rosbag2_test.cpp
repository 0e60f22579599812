#include <gmock/gmock.h>

#include <functional>

#include "ddtool/base/random.hpp"
#include "logs/containers/db3_source.hpp"
#include "read_log.hpp"
#include "rosbag2_folder_files.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using test::read_all;
using test::ReadLog;
using testing::ElementsAre;
using testing::HasSubstr;

class Rosbag2 : public testing::Test {
protected:
    Rosbag2() {
        test::write_db3_folder(folder_, test::example_recording(), 12);
        frames_ = read_all(folder_).frames;
    }
    void set_files(const std::vector<std::string>& names) { test::write_metadata(folder_, names); }

    test::TemporaryFolder temporary_;
    const std::filesystem::path folder_ = temporary_ / "recording";
    std::vector<SensorFrame> frames_;
};

TEST_F(Rosbag2, AMissingFileIsToldAndTheOthersAreRead) {
    std::filesystem::remove(folder_ / "part_5");
    const ReadLog log = read_all(folder_);
    EXPECT_THAT(log.problems, testing::Contains(testing::AllOf(HasSubstr("part_5"), HasSubstr("cannot read"))));
    EXPECT_EQ(log.frames.size() + 1, frames_.size());
    EXPECT_EQ(log.error, "");
}

TEST_F(Rosbag2, WithoutAnyFileThereIsNoLog) {
    for (int part = 0; part < 12; ++part) {
        std::filesystem::remove(folder_ / ("part_" + std::to_string(part)));
    }
    EXPECT_THAT(read_all(folder_).error, testing::AllOf(HasSubstr("part_0"), HasSubstr("cannot read")));
}

TEST_F(Rosbag2, WithoutMetadataFilesAreReadByTheirNumbers) {
    std::filesystem::remove(folder_ / "metadata.yaml");
    write_file(folder_ / "notes", "no log");
    const ReadLog log = read_all(folder_);
    EXPECT_THAT(log.problems, ElementsAre(HasSubstr("has no metadata.yaml")));
    EXPECT_EQ(log.frames.size(), frames_.size());
    EXPECT_TRUE(test::begins_with(frames_, log.frames));
}

TEST_F(Rosbag2, WithoutMetadataFilesOfSeveralRecordingsAreRefused) {
    std::filesystem::remove(folder_ / "metadata.yaml");
    std::filesystem::rename(folder_ / "part_3", folder_ / "other.db3");
    EXPECT_THAT(read_all(folder_).error, HasSubstr("not parts of one recording by their names"));
}

TEST_F(Rosbag2, OldMetadataNameTheFolderToo) {
    std::vector<std::string> names;
    for (int part = 0; part < 12; ++part) {
        names.push_back("recording/part_" + std::to_string(part));
    }
    set_files(names);
    EXPECT_TRUE(test::begins_with(read_all(folder_).frames, frames_));
}

TEST_F(Rosbag2, FilesOutsideOfTheFolderAreRefused) {
    for (const std::string name : {"../part_0", "/etc/passwd", "inner/../../part_0", ".."}) {
        set_files({"part_0", name});
        EXPECT_THAT(read_all(folder_).error, HasSubstr("names '" + name + "', which lies outside of the folder"));
    }
}

TEST_F(Rosbag2, AFileWhoseNameIsTooLongIsMissing) {
    set_files({"part_0", "part_1", "part_2", "part_3", std::string(300, 'a')});
    EXPECT_THAT(read_all(folder_).problems, testing::Contains(HasSubstr("File name too long")));
}

TEST_F(Rosbag2, MetadataThatSayNothingAreNamed) {
    for (const std::string text : {"", "[1, 2", "rosbag2_bagfile_information: 3", "\x01\x02"}) {
        write_file(folder_ / "metadata.yaml", text);
        const std::string error = read_all(folder_).error;
        EXPECT_THAT(error, HasSubstr("metadata.yaml: cannot read")) << text;
        EXPECT_THAT(error, testing::Not(HasSubstr("\n")));
    }
    set_files({});
    EXPECT_THAT(read_all(folder_).error, HasSubstr("metadata.yaml"));
}

TEST_F(Rosbag2, FilesMayHaveBeenUnpackedOrPackedAfterwards) {
    set_files({"part_3.zstd", "part_4"});
    const std::string content = read_file(folder_ / "part_4");
    const std::vector<std::byte> packed = compress(Compression::zstd, std::as_bytes(std::span(content)));
    write_file(folder_ / "part_4.zstd", std::string_view(reinterpret_cast<const char*>(packed.data()), packed.size()));
    std::filesystem::remove(folder_ / "part_4");
    const ReadLog log = read_all(folder_);
    EXPECT_EQ(log.error, "");
    EXPECT_THAT(log.problems, testing::IsEmpty());
}

TEST_F(Rosbag2, AnEmptyFolderIsNoLog) {
    std::filesystem::create_directory(temporary_ / "empty");
    EXPECT_THAT(read_all(temporary_ / "empty").error, HasSubstr("is a folder without a log"));
    write_file(temporary_ / "empty" / "a.bag", "#ROSBAG V2.0\n");
    EXPECT_THAT(read_all(temporary_ / "empty").error, HasSubstr("has ROS 1 bags, which are given one by one: "));
}

TEST(Db3, DatabasesOfOthersAreNamed) {
    const test::TemporaryFolder folder;
    test::Database(folder / "other").run("CREATE TABLE songs(name TEXT)");
    EXPECT_THAT(read_all(folder / "other").error,
                testing::AllOf(HasSubstr("no such table: topics"), HasSubstr("expected")));
}

TEST(Db3, MessagesWithoutTopicAreSkipped) {
    const test::TemporaryFolder folder;
    test::write_db3(folder / "log", test::example_recording());
    test::Database(folder / "log").run("DELETE FROM topics WHERE name = '/tf'");
    const ReadLog log = read_all(folder / "log");
    EXPECT_THAT(log.problems, ElementsAre(HasSubstr("is not in the table of topics")));
    EXPECT_EQ(log.frames.size(), 9U);
}

TEST(Db3, AMessageThatDoesNotUnpackIsSkipped) {
    const test::TemporaryFolder folder;
    test::write_db3(folder / "log", test::example_recording(), Compression::zstd);
    test::Database(folder / "log")
        .run(
            "UPDATE messages SET data = substr(data, 1, 20) WHERE topic_id = (SELECT id FROM topics WHERE name = "
            "'/scan') AND timestamp = 300000000");
    const ReadLog log = read_all(folder / "log");
    EXPECT_THAT(log.problems, ElementsAre(testing::AllOf(HasSubstr("/scan: skipped"), HasSubstr("near row"))));
    EXPECT_EQ(log.frames.size(), 8U);
}

TEST(Db3, DamagedMessagesAreToldByRow) {
    const test::TemporaryFolder folder;
    test::write_db3(folder / "log", test::example_recording());
    test::Database(folder / "log").run("UPDATE messages SET data = x'00010000ff' WHERE id = 3");
    EXPECT_THAT(read_all(folder / "log").problems, ElementsAre(HasSubstr("near row 3")));
}

/// A database of so many messages that its table is a tree of three levels. Some messages are longer than a page.
class DamagedDb3 : public testing::Test {
protected:
    DamagedDb3() {
        for (std::int64_t i = 0; i < 5000; ++i) {
            const std::size_t bytes = i % 10 == 0 ? 6000 : 500 + static_cast<std::size_t>(i % 97);
            std::vector<std::byte> data(bytes, static_cast<std::byte>(i % 251));
            recording_.push_back({i % 3 == 0 ? "/a" : "/b", "std_msgs/msg/String", 1'000'000 * i, {}, std::move(data)});
        }
        test::write_db3(file_, recording_);
        whole_ = read_file(file_);
    }

    struct Read {
        std::vector<std::size_t> messages;  ///< which of the recording, in the order in which they were read
        std::vector<std::string> problems;
    };
    Read read_database() {
        Read read;
        Db3Source source(file_, file_.string(),
                         [&](const LogProblem& problem) { read.problems.push_back(problem.what); });
        while (const auto message = source.next()) {
            const auto index = static_cast<std::size_t>(message->log_time_ns / 1'000'000);
            EXPECT_TRUE(index < recording_.size() && std::ranges::equal(message->data, recording_[index].cdr) &&
                        message->channel->topic == recording_[index].topic)
                << index;
            read.messages.push_back(index);
        }
        return read;
    }
    /// How many messages SQLite itself reads if it is told not to mind that pages are missing.
    [[nodiscard]] std::size_t read_by_sqlite() const {
        sqlite3* database = nullptr;
        sqlite3_open_v2(file_.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
        sqlite3_exec(database, "PRAGMA writable_schema=ON", nullptr, nullptr, nullptr);
        sqlite3_stmt* rows = nullptr;
        sqlite3_prepare_v2(database, "SELECT id, topic_id, timestamp, data FROM messages", -1, &rows, nullptr);
        std::size_t count = 0;
        while (rows != nullptr && sqlite3_step(rows) == SQLITE_ROW) {
            count += sqlite3_column_type(rows, 3) == SQLITE_BLOB ? 1 : 0;  // what is missing of a page reads as null
        }
        sqlite3_finalize(rows);
        sqlite3_close(database);
        return count;
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "log";
    test::Recording recording_;
    std::string whole_;
};

TEST_F(DamagedDb3, EveryMessageBeforeACutIsRead) {
    for (const double share : {0.1, 0.3, 0.5, 0.9}) {
        for (const std::size_t beyond_page : {std::size_t{0}, std::size_t{1234}}) {
            const auto bytes = static_cast<std::size_t>(share * static_cast<double>(whole_.size())) / 4096 * 4096;
            write_file(file_, whole_.substr(0, bytes + beyond_page));
            const Read read = read_database();
            EXPECT_GE(static_cast<double>(read.messages.size()), (share - 0.01) * 5000.0) << share;
            EXPECT_GE(read.messages.size() + (beyond_page > 0 ? 1 : 0), read_by_sqlite()) << share;
            EXPECT_TRUE(std::ranges::is_sorted(read.messages, std::less_equal<>())) << share;
            EXPECT_THAT(read.problems,
                        testing::Contains(HasSubstr("is cut off: " + std::to_string(bytes + beyond_page))));
        }
    }
}

TEST_F(DamagedDb3, PagesBehindDamagedOnesAreRead) {
    std::string bytes = whole_;
    const std::size_t start = bytes.size() / 4096 * 2 / 5 * 4096;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(start), 10 * 4096, '\xAA');
    write_file(file_, bytes);
    const Read read = read_database();
    EXPECT_GT(read.messages.size(), 4850U);
    EXPECT_LT(read.messages.size(), 5000U);
    EXPECT_EQ(read.messages.back(), 4999U);
    EXPECT_TRUE(std::ranges::is_sorted(read.messages, std::less_equal<>()));
    EXPECT_THAT(read.problems,
                testing::Contains(HasSubstr(std::to_string(5000 - read.messages.size()) + " of the rows")));
}

TEST_F(DamagedDb3, TheTreeIsNotNeeded) {
    std::string bytes = whole_;
    for (std::size_t page = 4096; page < bytes.size(); page += 4096) {
        if (bytes[page] == '\x05') {
            bytes[page] = '\x7F';  // no interior page of a table is left
        }
    }
    write_file(file_, bytes);
    EXPECT_EQ(read_database().messages.size(), 5000U);
}

/// Databases that are cut off or contain wrong bytes. What can be read is returned, and the loss is reported.
TEST(Db3, DamagedDatabasesDoNotBringTheReaderDown) {
    const test::TemporaryFolder folder;
    test::write_db3(folder / "log", test::example_recording());
    const std::string whole = read_file(folder / "log");
    RandomStream random{3};
    for (int repetition = 0; repetition < 40; ++repetition) {
        std::string bytes = whole.substr(0, 16 + random.index(whole.size() - 16));
        bytes[16 + random.index(bytes.size() - 16)] ^= '\x55';
        write_file(folder / "damaged", bytes);
        const ReadLog log = read_all(folder / "damaged");
        EXPECT_FALSE(log.error.empty() && log.problems.empty()) << repetition;
        EXPECT_LE(log.frames.size(), 9U);
    }
}

}  // namespace
}  // namespace ddtool
