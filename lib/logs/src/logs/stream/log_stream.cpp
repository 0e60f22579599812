#include "ddtool/logs/log_stream.hpp"

#include <utility>

#include "logs/stream/carmen_stream.hpp"
#include "logs/stream/log_container.hpp"
#include "logs/stream/message_log_stream.hpp"

namespace ddtool {
LogStream::LogStream(LogProblemHandler on_problem) : on_problem_(std::move(on_problem)) {}

void LogStream::report(const LogProblem& problem) {
    ++summary_.problems;
    if (summary_.first_problems.size() < LogSummary::most_told) {
        summary_.first_problems.push_back(problem.what);
    }
    summary_.bytes_lost += problem.bytes_lost;
    on_problem_(problem);
}

std::unique_ptr<LogStream> open_log(const std::filesystem::path& path, const LogOptions& options,
                                    LogProblemHandler on_problem) {
    const FoundLog log = find_log(path);
    if (log.container == LogContainer::carmen) {
        return std::make_unique<CarmenStream>(log, options, std::move(on_problem));
    }
    const auto open = [log](LogProblemHandler handler) { return open_messages(log, std::move(handler)); };
    return std::make_unique<MessageLogStream>(open, MessageLogStream::Opening::twice,
                                              std::string(name_of(log.container)), path.string(), options,
                                              std::move(on_problem));
}

}  // namespace ddtool
