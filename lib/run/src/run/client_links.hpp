#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace ddtool {

/// Identifies a connected client. A number is never used again for another client.
using ClientId = std::uint64_t;

/// The connections to the clients, as seen by the code that decides what is sent. Sending to a client that has
/// disconnected meanwhile is not an error: nothing is sent.
class ClientLinks {
public:
    virtual ~ClientLinks() = default;

    virtual void send_text(ClientId client, const std::string& text) = 0;
    virtual void send_binary(ClientId client, const std::string& bytes) = 0;
    /// Returns the number of bytes that still wait to be sent to the client, without those that the operating system
    /// has already accepted.
    [[nodiscard]] virtual std::size_t unsent_bytes(ClientId client) const = 0;
};

}  // namespace ddtool
