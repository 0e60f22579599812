#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ddtool/base/error.hpp"
#include "logs/containers/byte_source.hpp"
#include "logs/containers/mcap_reader.hpp"

namespace ddtool::test {

struct OwnedMessage {
    McapChannel channel;
    std::uint32_t sequence = 0;
    std::int64_t log_time_ns = 0;
    std::int64_t publish_time_ns = 0;
    std::string data;

    bool operator==(const OwnedMessage&) const = default;
};

/// Everything that results from reading a file.
struct ReadBack {
    std::vector<OwnedMessage> messages;
    std::vector<LogProblem> problems;
    std::optional<std::string> error;  ///< the error that ended the reading, if any
};

inline ReadBack read_back(ByteSource source) {
    ReadBack result;
    try {
        McapReader reader(std::move(source), [&](const LogProblem& problem) { result.problems.push_back(problem); });
        while (const auto message = reader.next()) {
            const auto* text = reinterpret_cast<const char*>(message->data.data());
            result.messages.push_back({*message->channel, message->sequence, message->log_time_ns,
                                       message->publish_time_ns, std::string(text, message->data.size())});
        }
    } catch (const Error& error) {
        result.error = error.what();
    }
    return result;
}

}  // namespace ddtool::test
