#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "logs/containers/message_source.hpp"

namespace ddtool {

/// Gives the beginning of a source twice that cannot be opened a second time: the messages read before rewind() are
/// kept and returned again after it. Messages of types that ddtool does not use are not kept, and point clouds, which
/// are large, may be given up as soon as there are laser scans.
class KeptMessages : public MessageSource {
public:
    KeptMessages(std::unique_ptr<MessageSource> source, bool scans_before_clouds)
        : source_(std::move(source)), scans_before_clouds_(scans_before_clouds) {}

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return source_->fraction_read(); }
    /// Starts again from the first message. May be called once.
    void rewind() { keeping_ = false; }

private:
    struct Kept {
        McapMessage message;
        std::vector<std::byte> data;
    };

    void keep(const McapMessage& message);

    std::unique_ptr<MessageSource> source_;
    bool scans_before_clouds_;
    bool has_scans_ = false;
    std::deque<Kept> kept_;
    std::vector<std::byte> given_;  ///< the data of the message that was returned again last
    bool keeping_ = true;
};

}  // namespace ddtool
