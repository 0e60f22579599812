#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ddtool {

struct LiveMessage {
    std::string topic;
    std::string type_name;
    std::int64_t stamp_ns = 0;
    std::vector<std::byte> data;  ///< the ROS 2 message, serialised as CDR
};

/// The messages of a topic since its first, for who comes late. When there are most_kept of them, every second one is
/// dropped, and from then on only every second, fourth, ... new one is kept, so that memory stays bounded however long
/// a run is.
class MessageHistory {
public:
    /// A screen is not wider in pixels.
    static constexpr std::size_t most_kept = 8192;

    void add(std::shared_ptr<const LiveMessage> message);
    /// Of the first message; there must be one.
    [[nodiscard]] std::int64_t first_stamp_ns() const { return kept_.front()->stamp_ns; }
    /// The messages that are kept, the oldest first, and the latest message.
    [[nodiscard]] std::vector<std::shared_ptr<const LiveMessage>> messages() const;

private:
    std::vector<std::shared_ptr<const LiveMessage>> kept_;
    std::shared_ptr<const LiveMessage> latest_;
    std::size_t every_ = 1;  ///< one message of this many is kept
    std::size_t seen_ = 0;
};

}  // namespace ddtool
