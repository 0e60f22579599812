#include "logs/stream/kept_messages.hpp"

#include <utility>

#include "logs/messages/message_decoder.hpp"

namespace ddtool {

std::optional<McapMessage> KeptMessages::next() {
    if (keeping_ || kept_.empty()) {
        const std::optional<McapMessage> message = source_->next();
        if (keeping_ && message &&
            (kind_of(*message->channel) != MessageKind::other || is_information(*message->channel))) {
            kept_.push_back({*message, {message->data.begin(), message->data.end()}});
        }
        return message;
    }
    McapMessage message = kept_.front().message;
    given_ = std::move(kept_.front().data);
    kept_.pop_front();
    message.data = given_;
    return message;
}

}  // namespace ddtool
