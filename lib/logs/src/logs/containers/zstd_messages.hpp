#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of another source, of which those are unpacked that are a zstd frame each: rosbag2's compression by
/// message. One that does not decompress is reported and skipped.
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
