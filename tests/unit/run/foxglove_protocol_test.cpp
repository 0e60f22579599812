#include "run/foxglove_protocol.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "logs/messages/ros2_schema.hpp"

namespace ddtool {
namespace {

template <typename Number>
Number number_at(const std::string& bytes, std::size_t place) {
    Number number{};
    std::memcpy(&number, bytes.data() + place, sizeof(Number));
    return number;
}

TEST(FoxgloveProtocol, TellsOfTheServer) {
    const Json message = Json::parse(foxglove_server_info("a name", "a session"));
    EXPECT_EQ(message.at("op"), "serverInfo");
    EXPECT_EQ(message.at("name"), "a name");
    EXPECT_EQ(message.at("sessionId"), "a session");
    EXPECT_EQ(message.at("capabilities"), Json::array({"time"}));
}

TEST(FoxgloveProtocol, AdvertisesChannelsWithTheirDefinitions) {
    const std::vector<FoxgloveChannel> channels{{0, "/map", "nav_msgs/msg/OccupancyGrid"},
                                                {1, "/path", "nav_msgs/msg/Path"}};
    const Json message = Json::parse(foxglove_advertisement(channels));
    EXPECT_EQ(message.at("op"), "advertise");
    ASSERT_EQ(message.at("channels").size(), channels.size());
    for (const FoxgloveChannel& channel : channels) {
        const Json& told = message.at("channels").at(channel.id);
        EXPECT_EQ(told.at("id"), channel.id);
        EXPECT_EQ(told.at("topic"), channel.topic);
        EXPECT_EQ(told.at("encoding"), "cdr");
        EXPECT_EQ(told.at("schemaEncoding"), "ros2msg");
        EXPECT_EQ(told.at("schemaName"), channel.type_name);
        EXPECT_EQ(told.at("schema"), ros2_schema(channel.type_name));
    }
    EXPECT_EQ(Json::parse(foxglove_advertisement({})).at("channels"), Json::array());
}

TEST(FoxgloveProtocol, DataAreASubscriptionATimeAndTheMessage) {
    const std::vector<std::byte> data{std::byte{7}, std::byte{0}, std::byte{9}};
    const std::string bytes = foxglove_data_message(0x01020304, 0x1122334455667788, data);
    ASSERT_EQ(bytes.size(), 1 + 4 + 8 + data.size());
    EXPECT_EQ(bytes[0], 1);
    EXPECT_EQ(bytes[1], 4) << "little endian";
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 1), 0x01020304U);
    EXPECT_EQ(number_at<std::int64_t>(bytes, 5), 0x1122334455667788);
    EXPECT_EQ(bytes.substr(13), std::string("\7\0\11", 3));
}

TEST(FoxgloveProtocol, TimeIsAStamp) {
    const std::string bytes = foxglove_time_message(1'700'000'000'123'456'789);
    ASSERT_EQ(bytes.size(), 9U);
    EXPECT_EQ(bytes[0], 2);
    EXPECT_EQ(number_at<std::int64_t>(bytes, 1), 1'700'000'000'123'456'789);
}

TEST(FoxgloveProtocol, StatusSurvivesTextThatIsNotUnicode) {
    const Json message = Json::parse(foxglove_status(FoxgloveStatusLevel::warning, "bad: \xff"));
    EXPECT_EQ(message.at("op"), "status");
    EXPECT_EQ(message.at("level"), 1);
}

TEST(FoxgloveProtocol, ReadsWhatAClientWants) {
    const FoxgloveRequest more = parse_foxglove_request(
        R"({"op":"subscribe","subscriptions":[{"id":4294967295,"channelId":3},{"id":0,"channelId":5}]})");
    ASSERT_EQ(more.subscribe.size(), 2U);
    EXPECT_EQ(more.subscribe[0].id, 4294967295U);
    EXPECT_EQ(more.subscribe[0].channel, 3U);
    EXPECT_EQ(more.subscribe[1].channel, 5U);
    EXPECT_TRUE(more.unsubscribe.empty());
    const FoxgloveRequest less = parse_foxglove_request(R"({"op":"unsubscribe","subscriptionIds":[0,1]})");
    EXPECT_EQ(less.unsubscribe, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(less.subscribe.empty());
}

class BadRequest : public testing::TestWithParam<std::string> {};

TEST_P(BadRequest, IsAnErrorOfOneLine) {
    try {
        parse_foxglove_request(GetParam());
        FAIL() << "taken";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(Requests, BadRequest,
                         testing::Values("", "{", "[]", "7", "\"op\"", "{}", R"({"op":7})", R"({"op":"subscribe"})",
                                         R"({"op":"subscribe","subscriptions":7})",
                                         R"({"op":"subscribe","subscriptions":[7]})",
                                         R"({"op":"subscribe","subscriptions":[{"id":1}]})",
                                         R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":0}]})",
                                         R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":4294967296}]})",
                                         R"({"op":"subscribe","subscriptions":[{"id":true,"channelId":0}]})",
                                         R"({"op":"unsubscribe","subscriptionIds":[0.5]})",
                                         R"({"op":"unsubscribe","subscriptionIds":"1"})",
                                         R"({"op":"getParameters","parameterNames":[]})", "{\"op\":\"\xff\n\"}",
                                         "{\"op\":\"line\\nline\"}", std::string(60'000, '['),
                                         R"({"op":"unsubscribe","subscriptionIds":[)" + std::string(30'000, '[') +
                                             std::string(30'000, ']') + "]}"));

}  // namespace
}  // namespace ddtool
