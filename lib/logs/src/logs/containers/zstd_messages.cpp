#include "logs/containers/zstd_messages.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "logs/containers/compression.hpp"

namespace ddtool {
namespace {

constexpr std::uint64_t max_message_bytes = std::uint64_t{1} << 30;

/// Whether a message begins with the magic number of a zstd frame. No CDR encapsulation header begins like this.
bool is_zstd_frame(std::span<const std::byte> data) {
    constexpr std::array magic{std::byte{0x28}, std::byte{0xB5}, std::byte{0x2F}, std::byte{0xFD}};
    return data.size() > magic.size() && std::ranges::equal(data.first(magic.size()), magic);
}

}  // namespace

ZstdMessages::ZstdMessages(std::unique_ptr<MessageSource> source, std::string file, LogProblemHandler on_problem)
    : source_(std::move(source)), file_(std::move(file)), on_problem_(std::move(on_problem)) {}

std::optional<McapMessage> ZstdMessages::next() {
    while (std::optional<McapMessage> message = source_->next()) {
        const bool packed = message->channel->message_encoding == "cdr" && is_zstd_frame(message->data);
        if (!packed || unpack(*message)) {
            return message;
        }
    }
    return std::nullopt;
}

bool ZstdMessages::unpack(McapMessage& message) {
    // If the frame does not state the size, or is damaged, this is a huge number (ZSTD_CONTENTSIZE_UNKNOWN or _ERROR).
    const std::uint64_t size = ZSTD_getFrameContentSize(message.data.data(), message.data.size());
    Decompressed unpacked{{}, "its size is not stated, or is more than " + std::to_string(max_message_bytes)};
    if (size <= max_message_bytes) {
        unpacked = decompress(Compression::zstd, message.data, size, unpacked_);
    }
    message.data = unpacked.records;
    if (!unpacked.failure.empty()) {
        on_problem_({file_ + ": " + message.channel->topic + ": skipped a compressed message near " +
                     message.offset_unit + " " + std::to_string(message.file_offset) + ": " + unpacked.failure});
    }
    return unpacked.failure.empty();
}

}  // namespace ddtool
