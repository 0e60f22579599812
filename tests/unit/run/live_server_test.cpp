#include "run/live_server.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "ddtool/system/settings.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "web_socket_client.hpp"

namespace ddtool {
namespace {

using test::WebSocketClient;

std::string subscribe(std::uint32_t id, std::uint32_t channel) {
    return Json{{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}}.dump();
}

/// The next data message. Messages of other kinds are skipped.
std::string next_data(WebSocketClient& client) {
    while (const auto message = client.next()) {
        if (!message->is_text && message->payload[0] == 1) {
            return message->payload;
        }
    }
    throw std::runtime_error("the server closed the connection");
}

std::int64_t stamp_of(const std::string& data) {
    std::int64_t stamp_ns = -1;
    if (data.size() >= 13) {
        std::memcpy(&stamp_ns, data.data() + 5, sizeof(stamp_ns));
    }
    return stamp_ns;
}

class LiveServerTest : public testing::Test {
protected:
    /// Writes a message of about 100 bytes for each pose.
    void write_path(std::int64_t stamp_ns, std::size_t poses) {
        server_.write(
            "/path", stamp_ns,
            RosPath{.header = {{stamp_ns}, "map"}, .poses = {poses, pose_message(stamp_ns, "map", {1.0, 2.0, 0.5})}});
    }

    /// A map is a single array. A path would be slow to write, because fast-cdr makes room for its numbers a few at a
    /// time.
    void write_map(std::int64_t stamp_ns, std::size_t cells) {
        RosOccupancyGrid map{.header = {{stamp_ns}, "map"}, .map_load_time = {}, .origin = {}, .data = {}};
        map.data.resize(cells);
        server_.write("/map", stamp_ns, map);
    }

    LiveServer server_{"127.0.0.1", 0};
    const std::vector<std::string> asked_{"foxglove.websocket.v1"};
};

TEST_F(LiveServerTest, WhoComesLateGetsWhatWasSaidLast) {
    write_path(1, 3);
    write_path(2, 4);
    WebSocketClient client(server_.place(), asked_);
    EXPECT_EQ(Json::parse(client.next()->payload).at("op"), "serverInfo");
    const Json advertised = Json::parse(client.next()->payload).at("channels");
    ASSERT_EQ(advertised.size(), 1U);
    EXPECT_EQ(advertised.at(0).at("topic"), "/path");
    EXPECT_EQ(advertised.at(0).at("schemaName"), "nav_msgs/msg/Path");
    client.send({true, subscribe(9, advertised.at(0).at("id"))});
    const std::string data = next_data(client);
    EXPECT_EQ(stamp_of(data), 2);
    const auto path = decode_cdr<RosPath>(std::as_bytes(std::span(data).subspan(13)));
    ASSERT_TRUE(path.has_value());
    EXPECT_EQ(path->poses.size(), 4U);
}

TEST_F(LiveServerTest, WhoReadsGetsEverything) {
    write_path(0, 1);
    WebSocketClient client(server_.place(), asked_);
    client.send({true, subscribe(0, 0)});
    EXPECT_EQ(stamp_of(next_data(client)), 0);
    for (std::int64_t stamp_ns = 1; stamp_ns <= 1000; ++stamp_ns) {
        write_path(stamp_ns, 10);
        EXPECT_EQ(stamp_of(next_data(client)), stamp_ns);
    }
}

TEST_F(LiveServerTest, NeitherWaitsForWhoDoesNotReadNorKeepsAllForHim) {
    write_map(0, 1);
    WebSocketClient sleeper(server_.place(), asked_);
    sleeper.send({true, subscribe(0, 0)});
    WebSocketClient reader(server_.place(), asked_);
    reader.send({true, subscribe(0, 0)});
    constexpr std::int64_t messages = 400;
    for (std::int64_t stamp_ns = 1; stamp_ns <= messages; ++stamp_ns) {
        write_map(stamp_ns, 500'000);  // 200 MB in total
    }
    while (stamp_of(next_data(reader)) < messages) {
    }
    std::int64_t read = 1;
    while (stamp_of(next_data(sleeper)) < messages) {
        ++read;
    }
    EXPECT_LT(read, messages / 2);
}

TEST_F(LiveServerTest, AHundredClientsWhoComeAndGoWhileItWrites) {
    write_path(0, 1);
    std::vector<std::unique_ptr<WebSocketClient>> clients;
    for (int i = 1; i <= 200; ++i) {
        clients.push_back(std::make_unique<WebSocketClient>(server_.place(), asked_));
        clients.back()->send({true, subscribe(0, 0)});
        if (clients.size() > 100) {
            clients.erase(clients.begin());
        }
        write_path(i, 100);
    }
    for (const auto& client : clients) {
        std::int64_t stamp_ns = 0;
        while (stamp_ns < 200) {
            const std::int64_t next = stamp_of(next_data(*client));
            ASSERT_GE(next, stamp_ns);
            stamp_ns = next;
        }
    }
}

}  // namespace
}  // namespace ddtool
