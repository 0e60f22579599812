#pragma once

#include <optional>

#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// The messages of a container, in its order. MCAP's terms serve for every container.
class MessageSource {
public:
    MessageSource() = default;
    virtual ~MessageSource() = default;
    MessageSource(const MessageSource&) = delete;
    MessageSource& operator=(const MessageSource&) = delete;

    /// The next message, valid until the next call; none at the end.
    virtual std::optional<McapMessage> next() = 0;
    /// Share read, 0..1; 0 where the length is unknown.
    [[nodiscard]] virtual double fraction_read() const = 0;
};

}  // namespace ddtool
