#include "logs/stream/live_log.hpp"

#include <utility>

#include "logs/containers/live_buffer.hpp"
#include "logs/containers/mcap_message_source.hpp"
#include "logs/stream/message_log_stream.hpp"

namespace ddtool {
namespace {

std::unique_ptr<LogStream> open_live(std::unique_ptr<LiveBuffer> bytes, const std::string& name,
                                     const LogOptions& options, LogProblemHandler on_problem) {
    const auto open = [&](LogProblemHandler handler) {
        return std::make_unique<McapMessageSource>(ByteSource(std::move(bytes), name), std::move(handler));
    };
    return std::make_unique<MessageLogStream>(open, MessageLogStream::Opening::once, "MCAP", name, options,
                                              std::move(on_problem));
}

}  // namespace

std::unique_ptr<LogStream> open_standard_input(const LogOptions& options, std::function<bool()> stop,
                                               LogProblemHandler on_problem) {
    return open_live(LiveBuffer::standard_input(std::move(stop)), "standard input", options, std::move(on_problem));
}

std::unique_ptr<LogStream> follow_log(const std::filesystem::path& path, const LogOptions& options,
                                      std::function<bool()> stop, LogProblemHandler on_problem) {
    return open_live(LiveBuffer::followed(path, std::move(stop)), path.string(), options, std::move(on_problem));
}

}  // namespace ddtool
