#include "logs/containers/log_file.hpp"

#include <gmock/gmock.h>

#include <array>

#include "compressed_text.hpp"
#include "ddtool/base/error.hpp"
#include "logs/containers/compression.hpp"
#include "logs/containers/line_reader.hpp"
#include "logs/containers/tar_reader.hpp"
#include "logs/containers/temporary_copy.hpp"
#include "system/atomic_file.hpp"
#include "tar_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

std::string lines_of(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += "line " + std::to_string(i * 2654435761U) + "\n";
    }
    return text;
}

std::string read_all(const LogFile& file, std::vector<LogProblem>& problems) {
    ByteSource source = open_bytes(file, [&](const LogProblem& problem) { problems.push_back(problem); });
    std::string text;
    std::array<std::byte, 1000> buffer{};
    while (const std::size_t got = source.read(buffer)) {
        text.append(reinterpret_cast<const char*>(buffer.data()), got);
    }
    EXPECT_GT(source.fraction_read(), 0.9);  // an archive may go on after the file
    return text;
}

template <Compression compression>
std::string packed(const std::string& text) {
    const std::vector<std::byte> bytes = compress(compression, std::as_bytes(std::span(text)));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Format {
    const char* name;
    std::string (*pack)(const std::string&);
};
constexpr Format plain{"plain", test::plain};
constexpr Format gzip{"gzip", test::gzip};
constexpr Format bzip2{"bzip2", test::bzip2};
constexpr Format zstd{"zstd", packed<Compression::zstd>};
constexpr Format lz4{"lz4", packed<Compression::lz4>};

std::string name_of(const testing::TestParamInfo<Format>& format) { return format.param.name; }

class Packed : public testing::TestWithParam<Format> {
protected:
    test::TemporaryFolder folder_;
    std::vector<LogProblem> problems_;
};

TEST_P(Packed, ComesOutAsItWentIn) {
    const std::string text = lines_of(20'000);
    write_file(folder_ / "log", GetParam().pack(text));
    EXPECT_EQ(read_all({folder_ / "log", ""}, problems_), text);
    EXPECT_TRUE(problems_.empty());
}

TEST_P(Packed, SeveralInARowAreOneText) {
    write_file(folder_ / "log", GetParam().pack("one\n") + GetParam().pack("two\n"));
    EXPECT_EQ(read_all({folder_ / "log", ""}, problems_), "one\ntwo\n");
}

INSTANTIATE_TEST_SUITE_P(Formats, Packed, testing::Values(plain, gzip, bzip2, zstd, lz4), name_of);

class Compressed : public Packed {};

TEST_P(Compressed, CutOffGivesTheBeginningAndOneProblem) {
    const std::string text = lines_of(200'000);
    const std::string packed = GetParam().pack(text);
    write_file(folder_ / "log", packed.substr(0, packed.size() * 3 / 4));
    const std::string beginning = read_all({folder_ / "log", ""}, problems_);
    EXPECT_EQ(beginning, text.substr(0, beginning.size()));
    EXPECT_GT(beginning.size(), text.size() / 3);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find("cut off"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, Compressed, testing::Values(gzip, bzip2, zstd, lz4), name_of);

TEST_P(Compressed, IsReadThroughOtherCompression) {
    const std::string text = lines_of(20'000);
    for (const Format& outer : {gzip, bzip2, zstd, lz4}) {
        write_file(folder_ / "log", outer.pack(GetParam().pack(text)));
        EXPECT_EQ(read_all({folder_ / "log", ""}, problems_), text) << outer.name;
    }
    EXPECT_TRUE(problems_.empty());
}

TEST_P(Compressed, WhatFollowsIsTold) {
    write_file(folder_ / "log", GetParam().pack("one\n") + "something else");
    EXPECT_EQ(read_all({folder_ / "log", ""}, problems_), "one\n");
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_THAT(problems_[0].what, testing::HasSubstr("followed by something else"));
}

TEST_P(Compressed, IsFoundInAnArchiveWhichIsCompressedItself) {
    const std::string text = lines_of(20'000);
    write_file(folder_ / "log", GetParam().pack(test::tar_archive({{"folder/a", "A"}, {"folder/b", text}})));
    EXPECT_EQ(read_all({folder_ / "log", "folder/b"}, problems_), text);
    write_file(folder_ / "log", test::tar_archive({{"folder/a", "A"}, {"folder/b", GetParam().pack(text)}}));
    EXPECT_EQ(read_all({folder_ / "log", "folder/b"}, problems_), text);
    EXPECT_TRUE(problems_.empty());
}

TEST(LogFile, SaysWhyItCannotBeOpened) {
    EXPECT_THROW(open_bytes({"/nonexistent/log", ""}, {}), Error);
    EXPECT_THROW(open_bytes({"/tmp", ""}, {}), Error);
    const test::TemporaryFolder folder;
    write_file(folder / "log", test::tar_archive({{"a", "A"}}));
    EXPECT_THROW(open_bytes({folder / "log", "b"}, {}), Error);
}

std::vector<std::string> names_in_archive(const std::string& archive) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", archive);
    std::vector<std::string> names;
    visit_archive(folder / "log", [&](const LogFile& file, auto /*start*/) { names.push_back(file.entry); });
    return names;
}

TEST(Tar, NamesAreReadInEveryDialect) {
    const std::string longest(250, 'x');
    const std::string two = test::tar_entry("short", "A") + test::tar_entry("b", "B");
    EXPECT_THAT(names_in_archive(test::tar_archive({{"a", "A"}, {"folder/b", ""}})),
                testing::ElementsAre("a", "folder/b"));
    EXPECT_THAT(names_in_archive(test::tar_entry("././@LongLink", longest + std::string(1, '\0'), 'L') + two),
                testing::ElementsAre(longest, "b"));
    EXPECT_THAT(names_in_archive(test::tar_entry("pax", "13 path=./\xc3\xa4\n", 'x') + two),
                testing::ElementsAre("./\xc3\xa4", "b"));
    EXPECT_THAT(names_in_archive(test::tar_entry("link", "", '2') + two), testing::ElementsAre("short", "b"));
}

TEST(Tar, ACutIsTold) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", test::tar_archive({{"a", std::string(5000, 'A')}}).substr(0, 3000));
    std::vector<LogProblem> problems;
    EXPECT_EQ(read_all({folder / "log", "a"}, problems).size(), 3000U - 1024U);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems[0].what, testing::HasSubstr("log/a: the archive is cut off"));
}

TEST(Tar, DamagedArchivesAreNone) {
    std::string archive = test::tar_archive({{"a", "A"}});
    EXPECT_TRUE(is_tar(std::as_bytes(std::span(archive))));
    archive[20] = 'x';
    EXPECT_FALSE(is_tar(std::as_bytes(std::span(archive))));
    EXPECT_FALSE(is_tar(std::as_bytes(std::span(archive)).first(100)));
    const std::string end(512, '\0');
    EXPECT_FALSE(is_tar(std::as_bytes(std::span(end))));
}

TEST(TemporaryCopy, IsGoneAfterwards) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", test::gzip("content"));
    std::filesystem::path path;
    {
        const TemporaryCopy copy(open_bytes({folder / "log", ""}, {}));
        path = copy.path();
        EXPECT_EQ(read_file(path), "content");
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(LineReader, CutsEndlessLinesAndGoesOn) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", std::string(3 * LineReader::max_line_bytes, 'x') + "\n\nlast");
    LineReader lines(open_bytes({folder / "log", ""}, {}));
    EXPECT_EQ(lines.next().value_or("").size(), LineReader::max_line_bytes);
    EXPECT_EQ(lines.next(), "");
    EXPECT_EQ(lines.next(), "last");
    EXPECT_EQ(lines.line_number(), 3U);
    EXPECT_FALSE(lines.next());
}

}  // namespace
}  // namespace ddtool
