#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "run/client_links.hpp"

namespace ddtool {

/// Callbacks for what clients do. The server's thread makes all of the calls.
struct WebSocketEvents {
    std::function<void(ClientId)> opened;
    std::function<void(ClientId)> closed;
    std::function<void(ClientId, const std::string& payload, bool is_text)> received;
    std::function<void()> tick;  ///< called about 20 times per second
};

/// A WebSocket server (RFC 6455) with a thread of its own, which never waits for a client. It drops clients that break
/// the protocol, stop responding, or send a message larger than any valid request, and clients beyond the first
/// most_clients.
class WebSocketServer : public ClientLinks {
public:
    static constexpr std::size_t most_clients = 128;

    /// Listens at an IP address; port 0 selects a free port. A client must request one of the subprotocols. Throws
    /// UsageError if `address` is not an IP address, and Error if it does not belong to this machine or if the port is
    /// in use.
    WebSocketServer(const std::string& address, std::uint16_t port, std::vector<std::string> subprotocols);
    /// Closes the connections. Waits about one second at most.
    ~WebSocketServer() override;
    WebSocketServer(const WebSocketServer&) = delete;
    WebSocketServer& operator=(const WebSocketServer&) = delete;

    /// Starts to serve clients. Call this only once.
    void start(WebSocketEvents events);
    /// Returns the address and port where the server listens, as they stand in a URL, such as 127.0.0.1:8765.
    [[nodiscard]] std::string place() const;
    /// Has the server's thread execute the task. This may be called from any thread; the members below may be called
    /// only from the server's own thread.
    void post(std::function<void()> task);

    void send_text(ClientId client, const std::string& text) override;
    void send_binary(ClientId client, const std::string& bytes) override;
    [[nodiscard]] std::size_t unsent_bytes(ClientId client) const override;

private:
    class Endpoint;
    std::unique_ptr<Endpoint> endpoint_;
};

}  // namespace ddtool
