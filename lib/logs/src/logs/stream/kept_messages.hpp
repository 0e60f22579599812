#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "logs/containers/message_source.hpp"

namespace ddtool {

/// A source that cannot be opened a second time: what is read before rewind() is kept and given again. Messages of
/// types that are not read here are not.
class KeptMessages : public MessageSource {
public:
    explicit KeptMessages(std::unique_ptr<MessageSource> source) : source_(std::move(source)) {}

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return source_->fraction_read(); }
    /// Once.
    void rewind() { keeping_ = false; }

private:
    struct Kept {
        McapMessage message;
        std::vector<std::byte> data;
    };

    std::unique_ptr<MessageSource> source_;
    std::deque<Kept> kept_;
    std::vector<std::byte> given_;  ///< of the last that was given again
    bool keeping_ = true;
};

}  // namespace ddtool
