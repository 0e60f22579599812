#include "logs/stream/kept_messages.hpp"

#include <utility>

#include "logs/messages/message_decoder.hpp"

namespace ddtool {

std::optional<McapMessage> KeptMessages::next() {
    if (keeping_ || kept_.empty()) {
        const std::optional<McapMessage> message = source_->next();
        if (keeping_ && message) {
            keep(*message);
        }
        return message;
    }
    McapMessage message = kept_.front().message;
    given_ = std::move(kept_.front().data);
    kept_.pop_front();
    message.data = given_;
    return message;
}

void KeptMessages::keep(const McapMessage& message) {
    const MessageKind kind = kind_of(*message.channel);
    if (kind == MessageKind::scan && scans_before_clouds_ && !has_scans_) {
        has_scans_ = true;
        std::erase_if(kept_, [](const Kept& kept) { return kind_of(*kept.message.channel) == MessageKind::cloud; });
    }
    const bool is_used = kind == MessageKind::cloud ? !has_scans_ : kind != MessageKind::other;
    if (is_used || is_information(*message.channel)) {
        kept_.push_back({message, {message.data.begin(), message.data.end()}});
    }
}

}  // namespace ddtool
