#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ddtool::test {

/// A WebSocket client that does something only inside its calls. What waits for the server waits without end.
class WebSocketClient {
public:
    struct Message {
        bool is_text = false;
        std::string payload;
    };

    /// Connects to a place as WebSocketServer::place() tells it.
    WebSocketClient(const std::string& place, const std::vector<std::string>& subprotocols);
    ~WebSocketClient();
    WebSocketClient(const WebSocketClient&) = delete;
    WebSocketClient& operator=(const WebSocketClient&) = delete;

    [[nodiscard]] bool is_open() const;
    /// The one that the server chose.
    [[nodiscard]] std::string subprotocol() const;
    void send(const Message& message);
    /// The next message; none once the server has closed the connection.
    std::optional<Message> next();

private:
    class State;
    std::unique_ptr<State> state_;
};

/// Sends these bytes after a proper handshake and returns what comes until the server closes the connection.
std::string answer_to_raw_bytes(const std::string& place, const std::string& subprotocol, const std::string& bytes);

}  // namespace ddtool::test
