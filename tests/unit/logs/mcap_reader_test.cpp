#include <gmock/gmock.h>

#include <array>

#include "logs/containers/mcap_fields.hpp"
#include "mcap_support.hpp"
#include "system/crc.hpp"

namespace ddtool::test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// Builds files record by record, for layouts that our writer does not produce.
class Records {
public:
    Records& header() { return record(McapOpcode::header, McapFieldWriter().put_string("").put_string("test")); }
    Records& schema(std::uint16_t id, std::string_view name) {
        return record(McapOpcode::schema, McapFieldWriter().put(id).put_string(name).put_string("x").put_string("y"));
    }
    Records& channel(std::uint16_t id, std::uint16_t schema, std::string_view topic) {
        McapFieldWriter metadata;
        metadata.put_string("key").put_string("value");
        return record(
            McapOpcode::channel,
            McapFieldWriter().put(id).put(schema).put_string(topic).put_string("cdr").put_array(metadata.bytes()));
    }
    Records& message(std::uint16_t channel, std::string_view data) {
        return record(McapOpcode::message, McapFieldWriter()
                                               .put(channel)
                                               .put(std::uint32_t{1})
                                               .put(std::uint64_t{20})
                                               .put(std::uint64_t{10})
                                               .put_bytes(std::as_bytes(std::span(data))));
    }
    Records& chunk(const Records& records) {
        const auto content = records.bytes_.bytes();
        return record(McapOpcode::chunk, McapFieldWriter()
                                             .put(std::uint64_t{20})
                                             .put(std::uint64_t{20})
                                             .put(std::uint64_t{content.size()})
                                             .put(crc32_of(content))
                                             .put_string("")
                                             .put(std::uint64_t{content.size()})
                                             .put_bytes(content));
    }
    Records& record(McapOpcode opcode, const McapFieldWriter& content) {
        bytes_.put_record(opcode, content);
        return *this;
    }
    Records& data_end() { return record(McapOpcode::data_end, McapFieldWriter().put(std::uint32_t{0})); }
    /// A whole file, without CRCs and without a summary.
    [[nodiscard]] std::string file() const { return Records(*this).data_end().file_without_data_end(); }
    [[nodiscard]] std::string file_without_data_end() const {
        McapFieldWriter file;
        file.put_bytes(mcap_magic).put_bytes(bytes_.bytes());
        file.put_record(McapOpcode::footer, McapFieldWriter().put_bytes(std::array<std::byte, 20>{}));
        file.put_bytes(mcap_magic);
        return {reinterpret_cast<const char*>(file.bytes().data()), file.size()};
    }

private:
    McapFieldWriter bytes_;
};

OwnedMessage expected(std::string_view topic, std::string data, std::uint16_t schema) {
    const McapSchema none;
    const McapSchema some{schema, "S", "x", "y"};
    return {{1, std::string(topic), "cdr", {{"key", "value"}}, schema == 0 ? none : some}, 1, 20, 10, std::move(data)};
}

TEST(McapReader, ReadsMessagesInAndOutsideOfChunks) {
    const Records chunk = Records().schema(5, "S").channel(1, 5, "/in").message(1, "one").message(1, "two");
    const ReadBack result = read_back(Records().header().chunk(chunk).message(1, "three").chunk(chunk).file());
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.messages,
                ElementsAre(expected("/in", "one", 5), expected("/in", "two", 5), expected("/in", "three", 5),
                            expected("/in", "one", 5), expected("/in", "two", 5)));
}

TEST(McapReader, PassesOverWhatItDoesNotKnow) {
    const McapFieldWriter anything = std::move(McapFieldWriter().put_string("anything"));
    const auto attachment = McapOpcode{0x09};
    const auto metadata = McapOpcode{0x0C};
    const auto future = McapOpcode{0x7F};
    const auto own = McapOpcode{0x80};
    Records records = Records().header().record(attachment, anything).record(future, anything).channel(1, 0, "/t");
    records.record(own, anything).message(1, "one").record(metadata, anything);
    records.chunk(Records().record(future, anything).message(1, "two").record(own, anything));
    const ReadBack result = read_back(records.file());
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.messages, ElementsAre(expected("/t", "one", 0), expected("/t", "two", 0)));
}

TEST(McapReader, FieldsThatALaterVersionAppendsAreIgnored) {
    McapFieldWriter channel;
    channel.put(std::uint16_t{1}).put(std::uint16_t{0}).put_string("/t").put_string("cdr");
    channel.put_array({}).put_string("new");
    const ReadBack result = read_back(Records().record(McapOpcode::channel, channel).message(1, "one").file());
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.messages, testing::SizeIs(1));
}

TEST(McapReader, MessagesOfAnUndefinedChannelAreReportedOnce) {
    Records records = Records().channel(1, 0, "/t").message(2, "lost").message(1, "one").message(2, "lost");
    const ReadBack result = read_back(records.file());
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("channel 2 is not defined"))));
    EXPECT_THAT(result.messages, ElementsAre(expected("/t", "one", 0)));
}

TEST(McapReader, ADefinitionThatChangesIsReportedAndTheFirstIsKept) {
    const ReadBack result = read_back(Records().channel(1, 0, "/a").channel(1, 0, "/b").message(1, "one").file());
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("differs from its first"))));
    EXPECT_THAT(result.messages, ElementsAre(expected("/a", "one", 0)));
}

TEST(McapReader, AChannelOfAnUnknownSchemaIsReported) {
    const ReadBack result = read_back(Records().channel(1, 9, "/a").file());
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("schema 9"))));
}

TEST(McapReader, AFooterWithoutADataEndIsReported) {
    const ReadBack result = read_back(Records().channel(1, 0, "/t").message(1, "one").file_without_data_end());
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::what, HasSubstr("Data End"))));
    EXPECT_THAT(result.messages, ElementsAre(expected("/t", "one", 0)));
}

TEST(McapReader, AMalformedRecordCostsItselfOnly) {
    const McapFieldWriter too_short = std::move(McapFieldWriter().put(std::uint16_t{1}));
    Records chunk = Records().message(1, "one").record(McapOpcode::message, too_short).message(1, "two");
    const ReadBack result = read_back(Records().channel(1, 0, "/t").chunk(chunk).file());
    EXPECT_THAT(result.problems, ElementsAre(Field(&LogProblem::bytes_lost, mcap_record_header_bytes + 2)));
    EXPECT_THAT(result.messages, ElementsAre(expected("/t", "one", 0), expected("/t", "two", 0)));
}

}  // namespace
}  // namespace ddtool::test
