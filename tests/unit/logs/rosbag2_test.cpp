#include <gmock/gmock.h>

#include "ddtool/base/random.hpp"
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
    EXPECT_THAT(log.problems, testing::Contains(testing::AllOf(HasSubstr("part_5"), HasSubstr("cannot open"))));
    EXPECT_EQ(log.frames.size() + 1, frames_.size());
    EXPECT_EQ(log.error, "");
}

TEST_F(Rosbag2, WithoutAnyFileThereIsNoLog) {
    for (int part = 0; part < 12; ++part) {
        std::filesystem::remove(folder_ / ("part_" + std::to_string(part)));
    }
    EXPECT_THAT(read_all(folder_).error, testing::AllOf(HasSubstr("part_0"), HasSubstr("cannot open")));
}

TEST_F(Rosbag2, WithoutMetadataFilesAreReadByTheirNumbers) {
    std::filesystem::remove(folder_ / "metadata.yaml");
    write_file(folder_ / "notes", "no log");
    const ReadLog log = read_all(folder_);
    EXPECT_THAT(log.problems, ElementsAre(HasSubstr("has no metadata.yaml")));
    EXPECT_EQ(log.frames.size(), frames_.size());
    EXPECT_TRUE(test::begins_with(frames_, log.frames));
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

TEST_F(Rosbag2, FilesThatArePackedAsAWholeAreRefusedWithTheWayOut) {
    set_files({"part_3.zstd"});
    write_file(folder_ / "part_3.zstd", std::string("\x28\xb5\x2f\xfd rest"));
    EXPECT_THAT(read_all(folder_).error, HasSubstr("`zstd -d FILE -o NEW` unpacks it"));
    std::filesystem::remove(folder_ / "part_3.zstd");
    EXPECT_EQ(read_all(folder_).error, "") << "unpacked, but the metadata still has the old name";
}

TEST_F(Rosbag2, AnEmptyFolderIsNoLog) {
    std::filesystem::create_directory(temporary_ / "empty");
    EXPECT_THAT(read_all(temporary_ / "empty").error, HasSubstr("is a folder without a log"));
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
