#include <gmock/gmock.h>

#include "mcap_support.hpp"

namespace ddtool::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t message_count = 300;

struct Layout {
    Compression compression;
    std::size_t chunk_bytes;
};

class McapRoundTrip : public testing::TestWithParam<Layout> {
protected:
    static McapWriterOptions options() { return {"", GetParam().compression, GetParam().chunk_bytes}; }
};

INSTANTIATE_TEST_SUITE_P(Layouts, McapRoundTrip,
                         testing::Values(Layout{Compression::none, 1}, Layout{Compression::none, 1000},
                                         Layout{Compression::none, 1U << 20}, Layout{Compression::lz4, 1},
                                         Layout{Compression::lz4, 1000}, Layout{Compression::lz4, 1U << 20},
                                         Layout{Compression::zstd, 1}, Layout{Compression::zstd, 1000},
                                         Layout{Compression::zstd, 1U << 20}));

TEST_P(McapRoundTrip, GivesTheMessagesWhateverTheLayout) {
    const ReadBack plain = read_back(example_file({"", Compression::none, 1U << 20}, message_count));
    const ReadBack result = read_back(example_file(options(), message_count));
    EXPECT_FALSE(result.error);
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.messages, SizeIs(message_count));
    EXPECT_EQ(result.messages, plain.messages);
}

TEST_P(McapRoundTrip, SameCallsGiveTheSameBytes) {
    EXPECT_EQ(example_file(options(), message_count), example_file(options(), message_count));
}

TEST_P(McapRoundTrip, AFileWithoutMessagesIsWhole) {
    const ReadBack result = read_back(example_file(options(), 0));
    EXPECT_FALSE(result.error);
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.messages, IsEmpty());
}

TEST(McapWriter, KeepsWhatItWasGiven) {
    const TemporaryFolder folder;
    const auto path = folder / "one.mcap";
    McapWriter writer(path);
    const auto first = writer.add_channel("/a", "json", "T", "jsonschema", "{}");
    const auto second = writer.add_channel("/b", "cdr", "", "", "", {{"owner", "x"}, {"note", ""}});
    writer.write(second, 5, bytes_of("later"));
    writer.write(first, 3, bytes_of("earlier"));
    writer.write(second, 9, bytes_of(""));
    writer.close();
    const McapChannel a{first, "/a", "json", {}, {1, "T", "jsonschema", "{}"}};
    const McapChannel b{second, "/b", "cdr", {{"owner", "x"}, {"note", ""}}, {}};
    EXPECT_EQ(read_back(ByteSource(path)).messages,
              (std::vector<OwnedMessage>{{b, 0, 5, 5, "later"}, {a, 0, 3, 3, "earlier"}, {b, 1, 9, 9, ""}}));
}

TEST(McapWriter, LeavesNothingWithoutClose) {
    const TemporaryFolder folder;
    const auto path = folder / "none.mcap";
    {
        McapWriter writer(path);
        writer.write(writer.add_channel("/a", "json", "", "", ""), 1, bytes_of("{}"));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST(McapWriter, SaysWhichFileItCannotCreate) {
    EXPECT_THAT([] { McapWriter("/nowhere/x.mcap"); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("/nowhere/x.mcap: cannot create")));
}

TEST(McapReader, FractionReadGrowsToOne) {
    const TemporaryFolder folder;
    const auto path = folder / "file.mcap";
    write_file(path, example_file({"", Compression::zstd, 500}, message_count));
    McapReader reader(path, [](const LogProblem&) {});
    double before = 0.0;
    while (reader.next()) {
        EXPECT_GE(reader.fraction_read(), before);
        before = reader.fraction_read();
    }
    EXPECT_EQ(reader.fraction_read(), 1.0);
    EXPECT_LT(before, 1.0);
}

}  // namespace
}  // namespace ddtool::test
