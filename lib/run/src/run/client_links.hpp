#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace ddtool {

/// A connected client. Numbers are not used twice.
using ClientId = std::uint64_t;

/// How those who decide what is sent reach the clients. Who is gone meanwhile is no error: nothing is sent.
class ClientLinks {
public:
    virtual ~ClientLinks() = default;

    virtual void send_text(ClientId client, const std::string& text) = 0;
    virtual void send_binary(ClientId client, const std::string& bytes) = 0;
    /// Bytes that wait for the client to read, not counting those that the system has taken.
    [[nodiscard]] virtual std::size_t unsent_bytes(ClientId client) const = 0;
};

}  // namespace ddtool
