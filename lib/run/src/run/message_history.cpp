#include "run/message_history.hpp"

#include <utility>

namespace ddtool {

void MessageHistory::add(std::shared_ptr<const LiveMessage> message) {
    if (seen_++ % every_ == 0) {
        if (kept_.size() == most_kept) {
            for (std::size_t place = 0; place < most_kept / 2; ++place) {
                kept_[place] = std::move(kept_[2 * place]);
            }
            kept_.resize(most_kept / 2);
            every_ *= 2;
        }
        kept_.push_back(message);
    }
    latest_ = std::move(message);
}

std::vector<std::shared_ptr<const LiveMessage>> MessageHistory::messages() const {
    std::vector<std::shared_ptr<const LiveMessage>> all = kept_;
    if (latest_ && all.back() != latest_) {
        all.push_back(latest_);
    }
    return all;
}

}  // namespace ddtool
