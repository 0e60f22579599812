#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/settings.hpp"
#include "logs/mcap_reader.hpp"
#include "mcap_read_back.hpp"

namespace ddtool::test {
namespace {

const std::filesystem::path samples = DDTOOL_MCAP_SAMPLES;

Json read_json(const std::string& name) { return Json::parse(read_file(samples / name)); }

std::string unhex(const std::string& hex) {
    std::string bytes;
    for (std::size_t at = 0; at < hex.size(); at += 2) {
        bytes += static_cast<char>(std::stoi(hex.substr(at, 2), nullptr, 16));
    }
    return bytes;
}

/// Without ids, which each writer chooses for itself.
McapChannel channel_of(const Json& json) {
    const Json& schema = json.at("schema");
    return {0,
            json.at("topic"),
            json.at("messageEncoding"),
            json.at("metadata"),
            {0, schema.at("name"), schema.at("encoding"), schema.at("data")}};
}

std::vector<OwnedMessage> expected_messages() {
    const Json expected = read_json("expected.json");
    std::map<std::string, McapChannel> channels;
    for (const Json& json : expected.at("channels")) {
        channels[json.at("topic")] = channel_of(json);
    }
    std::vector<OwnedMessage> messages;
    for (const Json& json : expected.at("messages")) {
        messages.push_back({channels.at(json.at("topic")), json.at("sequence"),
                            std::stoll(json.at("logTime").get<std::string>()),
                            std::stoll(json.at("publishTime").get<std::string>()), unhex(json.at("data"))});
    }
    return messages;
}

class McapSample : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(OfMcapCore, McapSample,
                         testing::ValuesIn(read_json("expected.json").at("samples").get<std::vector<std::string>>()),
                         [](const auto& sample) { return std::filesystem::path(sample.param).stem().string(); });

TEST_P(McapSample, HoldsTheMessagesThatWentIn) {
    ReadBack result = read_back(ByteSource(samples / GetParam()));
    for (OwnedMessage& message : result.messages) {
        message.channel.id = 0;
        message.channel.schema.id = 0;
    }
    EXPECT_FALSE(result.error);
    EXPECT_THAT(result.problems, testing::IsEmpty());
    EXPECT_EQ(result.messages, expected_messages());
}

}  // namespace
}  // namespace ddtool::test
