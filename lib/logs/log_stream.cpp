#include "logs/log_stream.hpp"

#include <utility>

#include "base/error.hpp"
#include "logs/carmen_message.hpp"
#include "logs/carmen_stream.hpp"
#include "logs/text_source.hpp"

namespace ddtool {
namespace {

constexpr std::size_t head_bytes = 1 << 16;

std::string read_head(const std::filesystem::path& path) {
    std::string head(head_bytes, '\0');
    head.resize(open_text(path, [](const LogProblem&) {})->read(head));
    return head;
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
    const std::string head = read_head(path);
    if (head.empty()) {
        throw Error(path.string() + ": is empty; expected a log");
    }
    if (looks_like_carmen(head)) {
        return std::make_unique<CarmenStream>(path, options, std::move(on_problem));
    }
    throw Error(path.string() + ": is no log of a known kind; expected CARMEN text (plain, gzip or bzip2)");
}

}  // namespace ddtool
