#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ddtool::test {

/// A WebSocket client that works only while one of its functions is running. Functions that wait for the server have no
/// time limit.
class WebSocketClient {
public:
    struct Message {
        bool is_text = false;
        std::string payload;
    };

    /// Connects to an address of the form that WebSocketServer::place() returns.
    WebSocketClient(const std::string& place, const std::vector<std::string>& subprotocols);
    ~WebSocketClient();
    WebSocketClient(const WebSocketClient&) = delete;
    WebSocketClient& operator=(const WebSocketClient&) = delete;

    [[nodiscard]] bool is_open() const;
    /// The subprotocol that the server chose.
    [[nodiscard]] std::string subprotocol() const;
    void send(const Message& message);
    /// The next message, or nothing if the server has closed the connection.
    std::optional<Message> next();

private:
    class State;
    std::unique_ptr<State> state_;
};

/// Sends these bytes after a proper handshake, and returns everything that arrives until the server closes the
/// connection.
std::string answer_to_raw_bytes(const std::string& place, const std::string& subprotocol, const std::string& bytes);

}  // namespace ddtool::test
