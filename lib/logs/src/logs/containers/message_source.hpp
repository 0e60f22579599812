#pragma once

#include <optional>

#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// The messages of a log in the order of the file. They are described in the terms of MCAP, whatever the format of the
/// file is. For one thread at a time.
class MessageSource {
public:
    MessageSource() = default;
    virtual ~MessageSource() = default;
    MessageSource(const MessageSource&) = delete;
    MessageSource& operator=(const MessageSource&) = delete;

    /// The next message; nullopt at the end. Valid until the next call.
    virtual std::optional<McapMessage> next() = 0;
    /// The share that has been read, 0..1; 0 if the length is unknown.
    [[nodiscard]] virtual double fraction_read() const = 0;
};

}  // namespace ddtool
