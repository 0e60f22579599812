#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <limits>

#include "logs/containers/mcap_fields.hpp"
#include "mcap_support.hpp"

namespace ddtool::test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

bool is_prefix(const std::vector<OwnedMessage>& part, const std::vector<OwnedMessage>& whole) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

/// The offset of the first record of a type, found by walking over the records from the start of the file.
std::size_t find_record(const std::string& file, McapOpcode opcode) {
    std::size_t at = mcap_magic.size();
    for (;;) {
        McapFieldReader fields(bytes_of(file).subspan(at));
        if (McapOpcode{fields.take<std::uint8_t>()} == opcode) {
            return at;
        }
        at += mcap_record_header_bytes + fields.take<std::uint64_t>();
    }
}

std::string text_of(const McapFieldWriter& fields) {
    return {reinterpret_cast<const char*>(fields.bytes().data()), fields.size()};
}

/// The file, in which the length of the first record of a type is replaced.
std::string with_length(std::string file, McapOpcode opcode, std::uint64_t length) {
    return file.replace(find_record(file, opcode) + 1, sizeof(length), text_of(McapFieldWriter().put(length)));
}

/// A file that consists of a single chunk with the given header.
std::string chunk_file(std::uint64_t uncompressed_size, std::string_view compression, std::span<const std::byte> data) {
    McapFieldWriter chunk;
    chunk.put(std::uint64_t{0}).put(std::uint64_t{0}).put(uncompressed_size).put(std::uint32_t{0});
    chunk.put_string(compression).put(std::uint64_t{data.size()}).put_bytes(data);
    McapFieldWriter file;
    file.put_bytes(mcap_magic).put_record(McapOpcode::chunk, chunk);
    file.put_record(McapOpcode::data_end, McapFieldWriter().put(std::uint32_t{0}));
    file.put_record(McapOpcode::footer, McapFieldWriter().put_bytes(std::array<std::byte, 20>{}));
    return text_of(file.put_bytes(mcap_magic));
}

class McapDamage : public testing::TestWithParam<Compression> {};

INSTANTIATE_TEST_SUITE_P(Compressions, McapDamage,
                         testing::Values(Compression::none, Compression::lz4, Compression::zstd));

TEST_P(McapDamage, AFileCutOffAnywhereGivesTheMessagesBeforeAndSaysSo) {
    const std::string file = example_file({"", GetParam(), 400}, 40);
    const ReadBack whole = read_back(file);
    std::size_t before = 0;
    for (std::size_t size = 0; size < file.size(); ++size) {
        const ReadBack part = read_back(file.substr(0, size));
        ASSERT_TRUE(is_prefix(part.messages, whole.messages)) << "cut at " << size;
        ASSERT_GE(part.messages.size(), before) << "cut at " << size;
        ASSERT_EQ(part.problems.size() + (part.error ? 1 : 0), 1U) << "cut at " << size;
        before = part.messages.size();
    }
    EXPECT_EQ(before, whole.messages.size());
}

TEST_P(McapDamage, AFlippedBitIsReportedOrHarmless) {
    const std::string file = example_file({"", GetParam(), 150}, 8);
    const ReadBack whole = read_back(file);
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
        std::string flipped = file;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
        const ReadBack result = read_back(flipped);
        const bool reported = result.error || !result.problems.empty();
        ASSERT_TRUE(reported || result.messages == whole.messages) << "bit " << bit;
        // A changed bit can turn a Message Index into a Message, which only the CRC of the data section reveals.
        ASSERT_LE(result.messages.size(), whole.messages.size() + 1) << "bit " << bit;
    }
}

TEST_P(McapDamage, ADamagedChunkIsSkippedAndTheOthersAreRead) {
    const std::string file = example_file({"", GetParam(), 400}, 40);
    const ReadBack whole = read_back(file);
    const std::size_t chunk = find_record(file, McapOpcode::chunk);
    const std::size_t inside = chunk + mcap_record_header_bytes + 60;
    std::string damaged = file;
    damaged[inside] = static_cast<char>(~damaged[inside]);
    const ReadBack result = read_back(damaged);
    ASSERT_THAT(result.problems, SizeIs(1));
    EXPECT_EQ(result.problems[0].offset, chunk);
    EXPECT_GT(result.problems[0].bytes_lost, 60U);
    EXPECT_FALSE(result.messages.empty());
    EXPECT_LT(result.messages.size(), whole.messages.size());
    EXPECT_TRUE(std::equal(result.messages.rbegin(), result.messages.rend(), whole.messages.rbegin()));
}

TEST_P(McapDamage, HugeLengthsAreProblemsNotAllocations) {
    const std::string file = example_file({"", GetParam(), 400}, 40);
    for (const auto opcode : {McapOpcode::header, McapOpcode::schema, McapOpcode::channel, McapOpcode::chunk,
                              McapOpcode::message_index, McapOpcode::data_end, McapOpcode::footer}) {
        for (const std::uint64_t length : {std::uint64_t{1} << 29, std::uint64_t{1} << 63, UINT64_MAX}) {
            const ReadBack result = read_back(with_length(file, opcode, length));
            EXPECT_THAT(result.problems, SizeIs(1)) << static_cast<int>(opcode) << ' ' << length;
            EXPECT_LE(result.problems.at(0).bytes_lost, std::uint64_t{1} << 29);
        }
    }
}

TEST(McapBomb, DecompressionStopsAtTheDeclaredSize) {
    const std::vector<std::byte> zeros(std::size_t{1} << 24);
    for (const auto compression : {Compression::lz4, Compression::zstd}) {
        std::vector<std::byte> buffer;
        const Decompressed result = decompress(compression, compress(compression, zeros), 1000, buffer);
        EXPECT_THAT(result.records, SizeIs(1000));
        EXPECT_THAT(result.failure, HasSubstr("more than the declared 1000 bytes"));
        EXPECT_LE(buffer.size(), 1001U);
    }
}

TEST(McapBomb, ADeclaredSizeIsNotAllocatedBeforeDataCome) {
    const std::vector<std::byte> few(100);
    for (const auto compression : {Compression::lz4, Compression::zstd}) {
        std::vector<std::byte> buffer;
        const Decompressed result = decompress(compression, compress(compression, few), mcap_max_held_bytes, buffer);
        EXPECT_THAT(result.records, SizeIs(100));
        EXPECT_THAT(result.failure, HasSubstr("decompresses to 100 bytes"));
        EXPECT_LE(buffer.capacity(), std::size_t{1} << 20);
    }
}

TEST(McapBomb, AChunkBeyondTheLimitIsRefused) {
    const ReadBack result = read_back(chunk_file(mcap_max_held_bytes + 1, "zstd", {}));
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("more than the limit"))));
}

TEST(McapChunk, OfAnUnknownCompressionIsSkipped) {
    const ReadBack result = read_back(chunk_file(5, "brotli", bytes_of("12345")));
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("compression 'brotli'"))));
}

TEST(McapChunk, ThatIsEmptyIsFine) { EXPECT_THAT(read_back(chunk_file(0, "", {})).problems, IsEmpty()); }

TEST(McapReader, SaysWhatAWrongFileLooksLike) {
    const auto error_of = [](const std::string& file) { return read_back(file).error.value_or("no error"); };
    EXPECT_EQ(error_of(""), "test.mcap: not an MCAP file of version 0: it is empty");
    EXPECT_THAT(error_of("#ROSBAG V2.0\n"), HasSubstr("starts like a ROS 1 bag"));
    EXPECT_THAT(error_of("SQLite format 3"), HasSubstr("an SQLite database"));
    EXPECT_THAT(error_of("FLASER 180 1.0"), HasSubstr("starts like a text file"));
    EXPECT_THAT(error_of("\x89MCAP1\r\n"), HasSubstr("another version"));
    EXPECT_THAT(error_of("\x01\x02\x03"), HasSubstr("no log that is known here"));
}

TEST(McapReader, SaysWhatFollowsTheEnd) {
    const std::string file = example_file({}, 10);
    const ReadBack result = read_back(file + "more");
    EXPECT_THAT(result.messages, SizeIs(10));
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::bytes_lost, 4U)));
}

TEST(McapReader, ATailOfZerosEndsTheReadingWithOneProblem) {
    const std::string file = example_file({"", Compression::none, 100}, 10);
    const std::size_t cut = find_record(file, McapOpcode::data_end);
    const ReadBack result = read_back(file.substr(0, cut) + std::string(5000, '\0'));
    EXPECT_THAT(result.messages, SizeIs(10));
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::bytes_lost, 5000U)));
}

}  // namespace
}  // namespace ddtool::test
