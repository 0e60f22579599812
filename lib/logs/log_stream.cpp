#include "logs/log_stream.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "logs/carmen_message.hpp"
#include "logs/carmen_stream.hpp"
#include "logs/file_kind.hpp"
#include "logs/mcap_message_source.hpp"
#include "logs/message_log_stream.hpp"
#include "logs/text_source.hpp"

namespace ddtool {
namespace {

constexpr std::size_t head_bytes = 1 << 16;

std::string read_head(const std::filesystem::path& path) {
    std::string head(head_bytes, '\0');
    head.resize(open_text(path, [](const LogProblem&) {})->read(head));
    return head;
}

std::unique_ptr<LogStream> open_mcap(const std::filesystem::path& path, const LogOptions& options,
                                     LogProblemHandler on_problem) {
    const auto open = [path](LogProblemHandler handler) {
        return std::make_unique<McapMessageSource>(path, std::move(handler));
    };
    return std::make_unique<MessageLogStream>(open, "MCAP", path.string(), options, std::move(on_problem));
}

}  // namespace

LogStream::LogStream(LogProblemHandler on_problem) : on_problem_(std::move(on_problem)) {}

void LogStream::report(const LogProblem& problem) {
    ++summary_.problems;
    summary_.bytes_lost += problem.bytes_lost;
    if (on_problem_) {
        on_problem_(problem);
    }
}

std::unique_ptr<LogStream> open_log(const std::filesystem::path& path, const LogOptions& options,
                                    LogProblemHandler on_problem) {
    constexpr std::string_view mcap_start = "\x89MCAP";
    const std::string head = read_head(path);
    if (head.starts_with(mcap_start)) {
        return open_mcap(path, options, std::move(on_problem));
    }
    if (looks_like_carmen(head)) {
        return std::make_unique<CarmenStream>(path, options, std::move(on_problem));
    }
    throw Error(path.string() + ": " +
                describe_file_start(std::as_bytes(std::span(head).first(std::min<std::size_t>(head.size(), 8)))) +
                "; expected an MCAP file or a CARMEN log (text, which may be gzip or bzip2)");
}

}  // namespace ddtool
