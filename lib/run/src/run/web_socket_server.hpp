#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "run/client_links.hpp"

namespace ddtool {

/// What clients do. All are called by the server's thread.
struct WebSocketEvents {
    std::function<void(ClientId)> opened;
    std::function<void(ClientId)> closed;
    std::function<void(ClientId, const std::string& payload, bool is_text)> received;
    std::function<void()> tick;  ///< some times a second
};

/// A WebSocket server (RFC 6455) with a thread of its own, which never waits for a client. Clients that break the
/// protocol, vanish, send more than a request needs, or are too many are dropped.
class WebSocketServer : public ClientLinks {
public:
    static constexpr std::size_t most_clients = 128;

    /// Listens at an IP address; port 0 takes one that is free. A client must ask for one of the subprotocols. Throws
    /// UsageError for what is no address, Error when it is not this machine's or the port is in use.
    WebSocketServer(const std::string& address, std::uint16_t port, std::vector<std::string> subprotocols);
    /// Says goodbye; waits about a second at most.
    ~WebSocketServer() override;
    WebSocketServer(const WebSocketServer&) = delete;
    WebSocketServer& operator=(const WebSocketServer&) = delete;

    /// From here on clients are served. Once.
    void start(WebSocketEvents events);
    /// Where it listens, as a URL has it: 127.0.0.1:8765.
    [[nodiscard]] std::string place() const;
    /// Has the server's thread do it. From any thread; all else from the server's own.
    void post(std::function<void()> task);

    void send_text(ClientId client, const std::string& text) override;
    void send_binary(ClientId client, const std::string& bytes) override;
    [[nodiscard]] std::size_t unsent_bytes(ClientId client) const override;

private:
    class Endpoint;
    std::unique_ptr<Endpoint> endpoint_;
};

}  // namespace ddtool
