#include "logs/containers/text_source.hpp"

#include <bzlib.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "compressed_text.hpp"
#include "ddtool/base/error.hpp"
#include "logs/containers/line_reader.hpp"
#include "system/atomic_file.hpp"
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

std::string read_all(const std::filesystem::path& path, std::vector<LogProblem>& problems) {
    const auto source = open_text(path, [&](const LogProblem& problem) { problems.push_back(problem); });
    std::string text;
    std::string buffer(1000, '\0');
    while (const std::size_t got = source->read(buffer)) {
        text.append(buffer, 0, got);
    }
    return text;
}

struct Format {
    const char* name;
    std::string (*pack)(const std::string&);
};
constexpr Format plain{"plain", test::plain};
constexpr Format gzip{"gzip", test::gzip};
constexpr Format bzip2{"bzip2", test::bzip2};

std::string name_of(const testing::TestParamInfo<Format>& format) { return format.param.name; }

class Packed : public testing::TestWithParam<Format> {
protected:
    test::TemporaryFolder folder_;
    std::vector<LogProblem> problems_;
};

TEST_P(Packed, ComesOutAsItWentIn) {
    const std::string text = lines_of(20'000);
    write_file(folder_ / "log", GetParam().pack(text));
    EXPECT_EQ(read_all(folder_ / "log", problems_), text);
    EXPECT_TRUE(problems_.empty());
}

TEST_P(Packed, SeveralInARowAreOneText) {
    write_file(folder_ / "log", GetParam().pack("one\n") + GetParam().pack("two\n"));
    EXPECT_EQ(read_all(folder_ / "log", problems_), "one\ntwo\n");
}

INSTANTIATE_TEST_SUITE_P(Formats, Packed, testing::Values(plain, gzip, bzip2), name_of);

class Compressed : public Packed {};

TEST_P(Compressed, CutOffGivesTheBeginningAndOneProblem) {
    const std::string text = lines_of(200'000);
    const std::string packed = GetParam().pack(text);
    write_file(folder_ / "log", packed.substr(0, packed.size() * 3 / 4));
    const std::string beginning = read_all(folder_ / "log", problems_);
    EXPECT_EQ(beginning, text.substr(0, beginning.size()));
    EXPECT_GT(beginning.size(), text.size() / 3);
    ASSERT_EQ(problems_.size(), 1U);
    EXPECT_NE(problems_[0].what.find("cut off"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, Compressed, testing::Values(gzip, bzip2), name_of);

TEST(TextSource, SaysWhyAFileCannotBeOpened) {
    EXPECT_THROW(open_text("/nonexistent/log", {}), Error);
    EXPECT_THROW(open_text("/tmp", {}), Error);
}

TEST(LineReader, CutsEndlessLinesAndGoesOn) {
    const test::TemporaryFolder folder;
    write_file(folder / "log", std::string(3 * LineReader::max_line_bytes, 'x') + "\n\nlast");
    LineReader lines(open_text(folder / "log", {}));
    EXPECT_EQ(lines.next().value_or("").size(), LineReader::max_line_bytes);
    EXPECT_EQ(lines.next(), "");
    EXPECT_EQ(lines.next(), "last");
    EXPECT_EQ(lines.line_number(), 3U);
    EXPECT_FALSE(lines.next());
}

}  // namespace
}  // namespace ddtool
