#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "logs/containers/message_source.hpp"

namespace ddtool {

/// Gives the beginning of a source twice that cannot be opened a second time: the messages read before rewind() are
/// kept and returned again after it. Messages of types that ddtool does not use are not kept.
class KeptMessages : public MessageSource {
public:
    explicit KeptMessages(std::unique_ptr<MessageSource> source) : source_(std::move(source)) {}

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return source_->fraction_read(); }
    /// Starts again from the first message. May be called once.
    void rewind() { keeping_ = false; }

private:
    struct Kept {
        McapMessage message;
        std::vector<std::byte> data;
    };

    std::unique_ptr<MessageSource> source_;
    std::deque<Kept> kept_;
    std::vector<std::byte> given_;  ///< the data of the message that was returned again last
    bool keeping_ = true;
};

}  // namespace ddtool
