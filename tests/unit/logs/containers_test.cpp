#include <gmock/gmock.h>

#include <functional>

#include "bag_file.hpp"
#include "db3_file.hpp"
#include "logs/stream/log_inventory.hpp"
#include "read_log.hpp"
#include "rosbag2_folder_files.hpp"
#include "system/atomic_file.hpp"
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

std::vector<Container> containers() {
    return {bag("bag", {}),
            bag("bag_of_one_chunk", {.messages_per_chunk = 1000}),
            bag("bag_lz4", {.compression = Compression::lz4}),
            bag("bag_bzip2", {.compression = Compression::bzip2, .messages_per_chunk = 1}),
            db3("db3", Compression::none),
            db3("db3_zstd_by_message", Compression::zstd),
            {"folder_of_db3", "rosbag2 folder",
             [](const auto& path, const Recording& recording) { test::write_db3_folder(path, recording, 3); }},
            {"folder_of_mcap", "rosbag2 folder",
             [](const auto& path, const Recording& recording) { test::write_mcap_folder(path, recording, 12); }}};
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

/// A file that was cut off, which every reader must report.
class CutFile : public testing::TestWithParam<std::string> {
protected:
    CutFile() {
        const Recording recording = test::example_recording();
        const std::string whole = GetParam() == "bag" ? BagFile(recording, {}).bytes() : mcap_bytes(recording);
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

INSTANTIATE_TEST_SUITE_P(All, CutFile, testing::Values("bag", "mcap"), [](const auto& kind) { return kind.param; });

}  // namespace
}  // namespace ddtool
