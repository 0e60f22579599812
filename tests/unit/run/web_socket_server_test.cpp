#include "run/web_socket_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "thrown_text.hpp"
#include "web_socket_client.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* home = "127.0.0.1";
constexpr const char* name = "first.v1";

/// A server that greets its clients, repeats what they send, and counts them.
class Echo {
public:
    Echo() {
        server_.start({.opened =
                           [this](ClientId client) {
                               ++opened_;
                               server_.send_text(client, "hello");
                           },
                       .closed = [this](ClientId) { ++closed_; },
                       .received =
                           [this](ClientId client, const std::string& payload, bool is_text) {
                               is_text ? server_.send_text(client, payload) : server_.send_binary(client, payload);
                           },
                       .tick = [] {}});
    }

    [[nodiscard]] std::string place() const { return server_.place(); }
    void wait_until_closed(int clients) const {
        while (closed_ < clients) {
            std::this_thread::yield();
        }
    }
    [[nodiscard]] int opened() const { return opened_; }
    WebSocketServer& server() { return server_; }

private:
    std::atomic<int> opened_ = 0;
    std::atomic<int> closed_ = 0;
    WebSocketServer server_{home, 0, {name, "second.v1"}};
};

std::string next_of(test::WebSocketClient& client) {
    return client.next().value_or(test::WebSocketClient::Message{}).payload;
}

TEST(WebSocketServer, TakesTheFirstSubprotocolThatItKnows) {
    const Echo echo;
    EXPECT_EQ(test::WebSocketClient(echo.place(), {name}).subprotocol(), name);
    EXPECT_EQ(test::WebSocketClient(echo.place(), {"other", "second.v1", name}).subprotocol(), "second.v1");
}

TEST(WebSocketServer, RefusesWhoAsksForNoneOfItsSubprotocols) {
    const Echo echo;
    EXPECT_FALSE(test::WebSocketClient(echo.place(), {}).is_open());
    EXPECT_FALSE(test::WebSocketClient(echo.place(), {"other"}).is_open());
    EXPECT_EQ(echo.opened(), 0);
}

TEST(WebSocketServer, PassesTextAndBytesOn) {
    const Echo echo;
    test::WebSocketClient client(echo.place(), {name});
    EXPECT_EQ(next_of(client), "hello");
    client.send({true, "text"});
    client.send({false, std::string("\0\xff", 2)});
    const auto text = client.next();
    const auto bytes = client.next();
    ASSERT_TRUE(text && bytes);
    EXPECT_TRUE(text->is_text);
    EXPECT_EQ(text->payload, "text");
    EXPECT_FALSE(bytes->is_text);
    EXPECT_EQ(bytes->payload, std::string("\0\xff", 2));
}

TEST(WebSocketServer, DropsWhoBreaksTheProtocolAndServesTheOthers) {
    const Echo echo;
    test::WebSocketClient friendly(echo.place(), {name});
    EXPECT_EQ(next_of(friendly), "hello");
    const std::string too_long = std::string("\x81\xff\0\0\0\0\0\2\0\0", 10) + "mask" + std::string(200'000, 'x');
    const std::vector<std::string> broken{
        std::string("\x81\x01x"),                                         // the payload is not masked
        std::string("\xff\x81maskx", 7),                                  // reserved bits and a reserved operation code
        std::string("\x81\xff\xff\xff\xff\xff\xff\xff\xff\xffmask", 14),  // announces 2^64 - 1 bytes
        std::string("\x89\xfe\x01\x00mask", 8) + std::string(256, 'x'),   // a ping that is too long for a control frame
        std::string("\x80\x81maskx", 7),                                  // continues a message that never began
        std::string("\x81\x82\0\0\0\0\xff\xfe", 8),                       // a text that is not valid UTF-8
        too_long,
    };
    for (const std::string& bytes : broken) {
        EXPECT_THAT(test::answer_to_raw_bytes(echo.place(), name, bytes), HasSubstr("hello"));
    }
    echo.wait_until_closed(static_cast<int>(broken.size()));
    friendly.send({true, "still there"});
    EXPECT_EQ(next_of(friendly), "still there");
}

TEST(WebSocketServer, SurvivesWhatIsNoWebSocketAtAll) {
    const Echo echo;
    EXPECT_THAT(test::answer_to_raw_bytes(echo.place(), "a\r\n\r\nb\r\nUpgrade: nothing", ""), Not(HasSubstr("hello")));
    test::WebSocketClient client(echo.place(), {name});
    EXPECT_EQ(next_of(client), "hello");
}

TEST(WebSocketServer, ForgetsWhoVanishes) {
    Echo echo;
    for (int i = 1; i <= 10; ++i) {
        { const test::WebSocketClient client(echo.place(), {name}); }  // leaves without closing the connection
        echo.wait_until_closed(i);
    }
    std::promise<std::size_t> unsent;
    echo.server().post([&] {
        echo.server().send_text(3, "to nobody");
        unsent.set_value(echo.server().unsent_bytes(3));
    });
    EXPECT_EQ(unsent.get_future().get(), 0U);
}

TEST(WebSocketServer, ServesAHundredClientsAndRefusesTooMany) {
    const Echo echo;
    std::vector<std::unique_ptr<test::WebSocketClient>> clients;
    for (std::size_t i = 0; i < WebSocketServer::most_clients; ++i) {
        clients.push_back(std::make_unique<test::WebSocketClient>(echo.place(), std::vector<std::string>{name}));
        clients.back()->send({true, std::to_string(i)});
    }
    for (std::size_t i = 0; i < clients.size(); ++i) {
        EXPECT_EQ(next_of(*clients[i]), "hello");
        EXPECT_EQ(next_of(*clients[i]), std::to_string(i));
    }
    EXPECT_FALSE(test::WebSocketClient(echo.place(), {name}).is_open());
    clients.pop_back();
    echo.wait_until_closed(1);
    EXPECT_TRUE(test::WebSocketClient(echo.place(), {name}).is_open());
}

TEST(WebSocketServer, SaysGoodbye) {
    auto echo = std::make_unique<Echo>();
    test::WebSocketClient client(echo->place(), {name});
    EXPECT_EQ(next_of(client), "hello");
    std::thread closing([&] { echo.reset(); });
    EXPECT_FALSE(client.next().has_value());
    closing.join();
}

TEST(WebSocketServer, DoesNotWaitForClientsThatDoNotAnswerItsGoodbye) {
    auto echo = std::make_unique<Echo>();
    const test::WebSocketClient deaf(echo->place(), {name});
    echo.reset();
}

TEST(WebSocketServer, SaysWhyItCannotListen) {
    const WebSocketServer first(home, 0, {name});
    const std::string place = first.place();
    const auto port = static_cast<std::uint16_t>(std::stoi(place.substr(place.rfind(':') + 1)));
    EXPECT_EQ(test::thrown_text([&] { WebSocketServer(home, port, {name}); }),
              "cannot serve at " + place + ": Address already in use");
    EXPECT_THAT(test::thrown_text([] { WebSocketServer("192.0.2.1", 0, {name}); }), HasSubstr("192.0.2.1"));
    EXPECT_THAT(test::thrown_text<UsageError>([] { WebSocketServer("nowhere", 0, {name}); }), HasSubstr("'nowhere'"));
}

}  // namespace
}  // namespace ddtool
