#include <gmock/gmock.h>

#include <functional>

#include "bag_file.hpp"
#include "compressed_text.hpp"
#include "db3_file.hpp"
#include "logs/stream/log_inventory.hpp"
#include "read_log.hpp"
#include "rosbag2_folder_files.hpp"
#include "system/atomic_file.hpp"
#include "tar_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using test::BagFile;
using test::BagOptions;
using test::Recording;

/// One way to store a recording.
struct Container {
    std::string name;
    std::string format;
    std::function<void(const std::filesystem::path&, const Recording&)> write;
};

Container bag(const std::string& name, const BagOptions& options) {
    return {name, "ROS 1 bag", [options](const std::filesystem::path& path, const Recording& recording) {
                write_file(path, BagFile(recording, options).bytes());
            }};
}

Container db3(const std::string& name, Compression packed) {
    return {name, "rosbag2 database", [packed](const std::filesystem::path& path, const Recording& recording) {
                test::write_db3(path, recording, packed);
            }};
}

using Pack = std::function<std::string(const std::string&)>;

Pack pack_with(Compression compression) {
    return [compression](const std::string& content) {
        const std::vector<std::byte> bytes = compress(compression, std::as_bytes(std::span(content)));
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
}

/// The file that `inner` writes, packed as a whole.
Container packed_file(const std::string& name, const Container& inner, const Pack& pack) {
    return {name, inner.format, [inner, pack](const std::filesystem::path& path, const Recording& recording) {
                inner.write(path, recording);
                write_file(path, pack(read_file(path)));
            }};
}

Container mcap() {
    return {"mcap", "MCAP", [](const auto& path, const Recording& recording) { test::write_mcap(path, recording); }};
}

/// A folder of rosbag2 whose files are compressed as a whole, as `ros2 bag record --compression-mode file` does.
void write_packed_folder(const std::filesystem::path& folder, const Recording& recording) {
    test::write_db3_folder(folder, recording, 3);
    std::vector<std::string> names;
    for (const std::string part : {"part_0", "part_1", "part_2"}) {
        names.push_back(part + ".zstd");
        write_file(folder / names.back(), pack_with(Compression::zstd)(read_file(folder / part)));
        std::filesystem::remove(folder / part);
    }
    test::write_metadata(folder, names);
}

/// A folder of rosbag2 in a compressed archive. The last file comes first in it.
void write_archived_folder(const std::filesystem::path& path, const Recording& recording) {
    const test::TemporaryFolder folder;
    test::write_mcap_folder(folder / "rec", recording, 3);
    std::vector<std::pair<std::string, std::string>> files;
    for (const std::string name : {"part_2", "metadata.yaml", "part_0", "part_1"}) {
        files.emplace_back("rec/" + name, read_file(folder / "rec" / name));
    }
    write_file(path, test::gzip(test::tar_archive(files)));
}

std::vector<Container> containers() {
    const auto in_archive = [](const std::string& content) {
        return test::gzip(test::tar_archive({{"notes.txt", "notes\n"}, {"rec/log", content}}));
    };
    return {bag("bag", {}),
            bag("bag_of_one_chunk", {.messages_per_chunk = 1000}),
            bag("bag_lz4", {.compression = Compression::lz4}),
            bag("bag_bzip2", {.compression = Compression::bzip2, .messages_per_chunk = 1}),
            db3("db3", Compression::none),
            db3("db3_zstd_by_message", Compression::zstd),
            {"folder_of_db3", "rosbag2 folder",
             [](const auto& path, const Recording& recording) { test::write_db3_folder(path, recording, 3); }},
            {"folder_of_mcap", "rosbag2 folder",
             [](const auto& path, const Recording& recording) { test::write_mcap_folder(path, recording, 12); }},
            packed_file("bag_in_gzip", bag("", {}), test::gzip),
            packed_file("bag_in_bzip2", bag("", {}), test::bzip2),
            packed_file("mcap_in_zstd", mcap(), pack_with(Compression::zstd)),
            packed_file("mcap_in_lz4", mcap(), pack_with(Compression::lz4)),
            packed_file("mcap_in_gzip", mcap(), test::gzip),
            packed_file("db3_in_zstd", db3("", Compression::none), pack_with(Compression::zstd)),
            packed_file("mcap_in_tar_gz", mcap(), in_archive),
            packed_file("db3_in_tar_gz", db3("", Compression::none), in_archive),
            packed_file("bag_in_tar_gz", bag("", {}), in_archive),
            {"folder_of_zstd", "rosbag2 folder", write_packed_folder},
            {"folder_in_tar_gz", "rosbag2 folder", write_archived_folder}};
}

class Containers : public testing::TestWithParam<Container> {};

/// The frames of every container must be the same as those of MCAP. The name of the file must not matter.
TEST_P(Containers, GiveTheFramesOfTheSameMessages) {
    const test::TemporaryFolder folder;
    const Recording recording = test::example_recording();
    test::write_mcap(folder / "measure", recording);
    GetParam().write(folder / "a log?100%.txt", recording);
    const test::ReadLog expected = test::read_all(folder / "measure");
    const test::ReadLog actual = test::read_all(folder / "a log?100%.txt");
    EXPECT_EQ(expected.frames.size(), 9U);
    EXPECT_EQ(actual.frames.size(), 9U);
    EXPECT_TRUE(test::begins_with(expected.frames, actual.frames));
    EXPECT_EQ(actual.error, "");
    EXPECT_THAT(actual.problems, testing::IsEmpty());
    EXPECT_EQ(actual.summary.format, GetParam().format);
    EXPECT_EQ(actual.summary.scan_topic, "/scan");
    EXPECT_EQ(actual.summary.odometry, expected.summary.odometry);
}

INSTANTIATE_TEST_SUITE_P(All, Containers, testing::ValuesIn(containers()),
                         [](const auto& container) { return container.param.name; });

TEST(FoundLog, MetadataStandForTheirFolder) {
    const test::TemporaryFolder folder;
    test::write_mcap_folder(folder / "rec", test::example_recording(), 3);
    const test::ReadLog log = test::read_all(folder / "rec" / "metadata.yaml");
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(log.frames.size(), 9U);
    EXPECT_EQ(log.summary.format, "rosbag2 folder");
}

TEST(FoundLog, ACutBeforeTheFirstBlockIsTold) {
    const test::TemporaryFolder folder;
    const std::string content = pack_with(Compression::zstd)(BagFile(test::example_recording(), {}).bytes());
    write_file(folder / "log", content.substr(0, 20));
    EXPECT_THAT(test::read_all(folder / "log").error, testing::HasSubstr("zstd data cut off"));
}

TEST(FoundLog, ArchivesWithSeveralLogsAreRefused) {
    const test::TemporaryFolder folder;
    const std::string content = BagFile(test::example_recording(), {}).bytes();
    write_file(folder / "log", test::tar_archive({{"a.bag", content}, {"b.bag", content}}));
    EXPECT_THAT(test::read_all(folder / "log").error, testing::HasSubstr("with 2 logs (a.bag, b.bag); unpack it"));
    write_file(folder / "log", test::tar_archive({{"notes", "n"}}));
    EXPECT_THAT(test::read_all(folder / "log").error, testing::HasSubstr("without a log; it has notes"));
}

/// Something that is given by mistake, and what the message must contain.
struct Mistaken {
    std::string name;
    std::string content;
    std::string expected;
};

class NamedForWhatItIs : public testing::TestWithParam<Mistaken> {};

TEST_P(NamedForWhatItIs, InOneLineWithTheWayOut) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", GetParam().content);
    const std::string error = test::read_all(folder / "log").error;
    EXPECT_THAT(error, testing::AllOf(testing::StartsWith((folder / "log").string() + ": "),
                                      testing::HasSubstr(GetParam().expected), testing::Not(testing::HasSubstr("\n"))));
}

std::string encrypted_bag() {
    return "#ROSBAG V2.0\n" + BagFile::record(3,
                                              BagFile::field("index_pos", std::string(8, '\0')) +
                                                  BagFile::field("encryptor", "rosbag/AesCbcEncryptor"),
                                              std::string(100, ' '));
}

const std::vector<Mistaken> mistaken{
    {"empty", "", "is empty"},
    {"encrypted", encrypted_bag(), "encrypted ROS 1 bag (rosbag/AesCbcEncryptor); `rosbag decrypt FILE`"},
    {"old_record", "#ROSRECORD V1.1\nrest", "a ROS bag of version 1; `rosbag fix"},
    {"old_bag", "#ROSBAG V1.2\nrest", "of another version; `rosbag fix` renews it"},
    {"cmu", "O 0.0 0.0 0.0 0.1\nL 1.0 2.0 0.1 1.0 2.0 0.1 100 200 300 0.2\n", "the lines L and O"},
    {"tum", "# time x y z qx qy qz qw\n1.5 0 0 0 0 0 0 1\n", "a trajectory (TUM"},
    {"csv", "time,x,y,theta\n1,2,3,4\n", "a table (CSV)"},
    {"ply", "ply\nformat ascii 1.0\n", "a point cloud (PLY)"},
    {"pcd", "VERSION .7\nFIELDS x y z\nDATA ascii\n", "a point cloud (PCD)"},
    {"pcd_with_comment", "# .PCD v.7 - Point Cloud Data file format\n", "a point cloud (PCD)"},
    {"png", "\x89PNG\r\n\x1a\n", "a PNG picture"},
    {"pgm", "P5\n3 3\n255\n", "a PGM picture or map"},
    {"map", "image: map.pgm\nresolution: 0.05\n", "the description of a map (YAML)"},
    {"zip", std::string("PK\x03\x04rest"), "a zip archive; unpack it (`unzip FILE`)"},
    {"hdf5", std::string("\x89HDF\r\n\x1a\n"), "an HDF5 file"},
    {"xz", std::string("\xfd\x37zXZ\0", 6), "an xz file (`xz -dk FILE` unpacks it)"},
    {"pcap", std::string("\xd4\xc3\xb2\xa1\2\0\4\0", 8), "a network capture (pcap)"},
    {"text", "hello\n", "a text file"},
};

INSTANTIATE_TEST_SUITE_P(All, NamedForWhatItIs, testing::ValuesIn(mistaken),
                         [](const auto& one) { return one.param.name; });

/// A file that was cut off, which every reader must report.
class CutFile : public testing::TestWithParam<std::string> {
protected:
    CutFile() {
        const Recording recording = test::example_recording();
        const std::string content =
            GetParam().starts_with("bag") ? BagFile(recording, {}).bytes() : mcap_bytes(recording);
        const std::string whole = GetParam().ends_with("gzip") ? test::gzip(content) : content;
        write_file(file_, whole.substr(0, 3 * whole.size() / 4));
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "log";

private:
    std::string mcap_bytes(const Recording& recording) {
        test::write_mcap(file_, recording);
        return read_file(file_);
    }
};

TEST_P(CutFile, GivesTheSameToWhoDoesNotAskForProblems) {
    const test::ReadLog heard = test::read_all(file_);
    EXPECT_FALSE(heard.problems.empty());
    const test::ReadLog unheard = test::read_all([&](const auto&) { return open_log(file_, {}, {}); });
    EXPECT_EQ(unheard.error, "");
    EXPECT_EQ(unheard.frames.size(), heard.frames.size());
    EXPECT_EQ(unheard.summary.problems, heard.summary.problems);
    EXPECT_GT(take_inventory(file_, {}, [](double) {}).messages(), 0U);
}

INSTANTIATE_TEST_SUITE_P(All, CutFile, testing::Values("bag", "mcap", "bag_in_gzip"),
                         [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace ddtool
