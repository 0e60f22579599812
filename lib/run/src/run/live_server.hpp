#pragma once

#include <cstddef>
#include <cstdint>
#include <semaphore>
#include <span>
#include <string>

#include "logs/messages/ros2_sink.hpp"
#include "run/broadcast.hpp"
#include "run/web_socket_server.hpp"

namespace ddtool {

/// Passes messages on to connected viewers such as Foxglove or Lichtblick. What is written is handed over to the
/// server's thread, which never waits for a client; so writing takes little longer than copying the message.
class LiveServer : public Ros2Sink {
public:
    /// Starts to serve clients. Throws what the constructor of WebSocketServer throws.
    LiveServer(const std::string& address, std::uint16_t port);

    /// Returns the address and port as they stand in a URL.
    [[nodiscard]] std::string place() const { return network_.place(); }

protected:
    void put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
             std::span<const std::byte> data) override;

private:
    static constexpr std::ptrdiff_t most_waiting = 64;

    std::counting_semaphore<most_waiting> room_{most_waiting};  ///< for messages on their way to the server's thread
    Broadcast broadcast_;                                       ///< used by the server's thread alone
    WebSocketServer network_;                                   ///< declared last, so that its thread ends first
};

}  // namespace ddtool
