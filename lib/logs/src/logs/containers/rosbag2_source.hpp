#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/log_file.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of a rosbag2 folder, one file after the other. A file that is missing or cannot be opened is reported
/// and skipped.
class Rosbag2Source : public MessageSource {
public:
    using OpenFile = std::function<std::unique_ptr<MessageSource>(const LogFile&)>;

    /// \param files the storage files, see rosbag2_files()
    /// \param open opens one of them
    /// Throws Error if none of the files can be opened.
    Rosbag2Source(std::vector<LogFile> files, OpenFile open, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override;

private:
    /// Makes the next file that can be opened the current one, or none after the last. Returns the first failure, or an
    /// empty text.
    std::string advance();

    LogProblemHandler on_problem_;
    OpenFile open_;
    std::vector<LogFile> files_;
    std::size_t opened_ = 0;  ///< number of files that were opened or skipped
    std::unique_ptr<MessageSource> current_;
};

}  // namespace ddtool
