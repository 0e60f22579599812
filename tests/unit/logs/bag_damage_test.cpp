#include <gmock/gmock.h>

#include <fstream>

#include "bag_file.hpp"
#include "ddtool/base/random.hpp"
#include "read_log.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using test::BagFile;
using test::ReadLog;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ReadLog read(const std::string& bytes) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "log.bag", std::ios::binary) << bytes;
    return test::read_all(folder / "log.bag");
}

class BagDamage : public testing::TestWithParam<Compression> {
protected:
    const BagFile whole_{test::example_recording(), {.compression = GetParam()}};
    const std::vector<SensorFrame> frames_ = read(whole_.bytes()).frames;
};

INSTANTIATE_TEST_SUITE_P(Compressions, BagDamage,
                         testing::Values(Compression::none, Compression::lz4, Compression::bzip2));

TEST_P(BagDamage, ABagThatWasNeverClosedGivesAllItsMessages) {
    const BagFile open(test::example_recording(), {.compression = GetParam(), .closed = false});
    const ReadLog log = read(open.bytes());
    EXPECT_EQ(log.frames.size(), frames_.size());
    EXPECT_TRUE(test::begins_with(frames_, log.frames));
    EXPECT_THAT(log.problems, ElementsAre(HasSubstr("was never closed")));
}

/// Cuts the bag off at many places. The frames must be the first frames of the whole bag, and the loss must be
/// reported. The last frames may lack the odometry that followed them in the file.
TEST_P(BagDamage, ABagThatIsCutOffGivesWhatCameBefore) {
    const std::size_t index = whole_.chunk_offsets().back();
    RandomStream random{5};
    for (int repetition = 0; repetition < 60; ++repetition) {
        const std::size_t size = 13 + random.index(index - 13);
        const ReadLog log = read(whole_.bytes().substr(0, size));
        if (!log.error.empty()) {
            EXPECT_THAT(log.error, HasSubstr("holds no laser scans")) << size;
            continue;
        }
        ASSERT_FALSE(log.frames.empty());
        const std::vector<SensorFrame> all_but_last(log.frames.begin(), log.frames.end() - 1);
        EXPECT_TRUE(test::begins_with(frames_, all_but_last)) << size;
        EXPECT_THAT(log.problems, testing::SizeIs(testing::Ge(1U))) << size;
    }
}

/// The damaged first chunk holds the definitions of the connections, so they must be read from the index.
TEST_P(BagDamage, ADamagedChunkIsSkipped) {
    std::string bytes = whole_.bytes();
    const std::size_t size_field = bytes.find("size=", whole_.chunk_offsets().front());
    bytes[size_field + 5] = static_cast<char>(bytes[size_field + 5] + 1);
    const ReadLog log = read(bytes);
    EXPECT_EQ(log.error, "");
    EXPECT_THAT(log.problems, testing::Contains(HasSubstr("record is skipped: its chunk: decompresses to")));
    EXPECT_EQ(log.frames.size() + 2, frames_.size());
}

TEST(BagDamageTest, AChunkThatDoesNotDecompressIsSkipped) {
    const BagFile whole(test::example_recording(), {.compression = Compression::lz4});
    std::string bytes = whole.bytes();
    bytes[bytes.find(std::string("\x04\x22\x4d\x18", 4), whole.chunk_offsets()[2])] = 'X';
    const ReadLog log = read(bytes);
    EXPECT_EQ(log.error, "");
    EXPECT_THAT(log.problems, testing::Contains(HasSubstr("ERROR_frameType_unknown")));
    EXPECT_THAT(log.frames, testing::Not(IsEmpty()));
}

/// Replaces each length in the file by 2^31. The reader must not allocate that much memory, and must report it in one
/// line.
TEST(BagDamageTest, HugeLengthsAreTold) {
    const BagFile whole(test::example_recording(), {});
    const std::string huge = BagFile::raw(std::uint32_t{1} << 31U);
    const std::size_t chunk = whole.chunk_offsets()[1];
    const std::size_t data_length = whole.bytes().find("size=", chunk) + 9;
    for (const std::size_t at : {std::size_t{13}, chunk, chunk + 4, data_length - 4, data_length, data_length + 4}) {
        std::string bytes = whole.bytes();
        bytes.replace(at, huge.size(), huge);
        const ReadLog log = read(bytes);
        EXPECT_THAT(log.problems.size() + log.error.size(), testing::Gt(0U)) << at;
    }
}

/// Changes random bytes. The reader must neither crash nor run for ever.
TEST_P(BagDamage, AnyByteMayBeWrong) {
    RandomStream random{9};
    for (int repetition = 0; repetition < 100; ++repetition) {
        std::string bytes = whole_.bytes();
        bytes[13 + random.index(bytes.size() - 13)] = static_cast<char>(random.index(256));
        EXPECT_LE(read(bytes).frames.size(), frames_.size());
    }
}

TEST(BagDamageTest, RecordsOutsideOfChunksAreRead) {
    const BagFile unclosed(test::example_recording(), {.messages_per_chunk = 1000, .closed = false});
    EXPECT_EQ(read(unclosed.bytes()).frames.size(), 9U);
}

TEST(BagDamageTest, OtherVersionsAndFilesAreNamed) {
    EXPECT_THAT(read("#ROSBAG V1.2\n").error, HasSubstr("version 2.0: it starts like a ROS 1 bag of another version"));
    EXPECT_THAT(read("#ROSBAG V2.0\n").error, HasSubstr("holds no laser scans"));
    EXPECT_THAT(read(BagFile({}, {}).bytes()).error, HasSubstr("found no messages"));
}

}  // namespace
}  // namespace ddtool
