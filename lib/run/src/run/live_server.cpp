#include "run/live_server.hpp"

#include <chrono>
#include <memory>

namespace ddtool {
namespace {

/// A name that differs for each start of the server, so that clients can tell a restarted server from the old one.
std::string session_name() { return std::to_string(std::chrono::system_clock::now().time_since_epoch().count()); }

}  // namespace

LiveServer::LiveServer(const std::string& address, std::uint16_t port)
    : broadcast_(network_, session_name()), network_(address, port, foxglove_subprotocols) {
    network_.start({.opened = [this](ClientId client) { broadcast_.opened(client); },
                    .closed = [this](ClientId client) { broadcast_.closed(client); },
                    .received = [this](ClientId client, const std::string& payload,
                                       bool is_text) { broadcast_.received(client, payload, is_text); },
                    .tick = [this] { broadcast_.catch_up(Broadcast::Clock::now()); }});
}

void LiveServer::put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
                     std::span<const std::byte> data) {
    auto message =
        std::make_shared<const LiveMessage>(LiveMessage{topic, type_name, stamp_ns, {data.begin(), data.end()}});
    room_.acquire();
    network_.post([this, message = std::move(message)] {
        broadcast_.publish(message);
        room_.release();
    });
}

}  // namespace ddtool
