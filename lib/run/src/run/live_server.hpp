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

/// Passes messages on to whoever listens: Foxglove, Lichtblick. What is written is handed over to the server's thread,
/// which waits for nobody, so a writer waits for little more than a copy and never for a client.
class LiveServer : public Ros2Sink {
public:
    /// Serves from here on. Throws as WebSocketServer does.
    LiveServer(const std::string& address, std::uint16_t port);

    /// Address and port, as a URL has them.
    [[nodiscard]] std::string place() const { return network_.place(); }

protected:
    void put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
             std::span<const std::byte> data) override;

private:
    static constexpr std::ptrdiff_t most_waiting = 64;

    std::counting_semaphore<most_waiting> room_{most_waiting};  ///< for messages on their way to the thread
    Broadcast broadcast_;                                       ///< the thread's alone
    WebSocketServer network_;                                   ///< last, so that the thread ends first
};

}  // namespace ddtool
