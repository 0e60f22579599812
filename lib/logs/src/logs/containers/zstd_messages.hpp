#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of another source, decompressed if a message is a zstd frame (rosbag2's compression by message). A
/// message that cannot be decompressed is reported and skipped.
class ZstdMessages : public MessageSource {
public:
    ZstdMessages(std::unique_ptr<MessageSource> source, std::string file, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return source_->fraction_read(); }

private:
    bool unpack(McapMessage& message);

    std::unique_ptr<MessageSource> source_;
    std::string file_;
    LogProblemHandler on_problem_;
    std::vector<std::byte> unpacked_;
};

}  // namespace ddtool
