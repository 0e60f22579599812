#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/line_reader.hpp"
#include "logs/containers/log_file.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The file formats of logs.
enum class LogContainer { mcap, ros1_bag, db3, rosbag2_folder, carmen };

/// "MCAP", "ROS 1 bag" and so on.
std::string_view name_of(LogContainer container);

/// A log that has been found.
struct FoundLog {
    LogContainer container = LogContainer::mcap;
    std::filesystem::path path;  ///< as it was given; for rosbag2 of its metadata.yaml, the folder of that
    /// What to open: one file, or the storage files of a rosbag2 recording in an archive; empty for a folder, whose
    /// files are looked for when it is opened.
    std::vector<LogFile> files;
};

/// Finds the log that a path stands for, recognised by content, not by name: a file in one of the formats, a rosbag2
/// folder or its metadata.yaml, or a tar archive with one log; the files may be compressed. Throws Error naming the
/// file, what it looks like and what to do if it is nothing of this or cannot be opened.
FoundLog find_log(const std::filesystem::path& path);

/// The messages of a log in any format except CARMEN, whose lines are not messages with a type and an encoding. Throws
/// Error as the readers of the formats do.
std::unique_ptr<MessageSource> open_messages(const FoundLog& log, LogProblemHandler on_problem);

/// The lines of a CARMEN log. Throws Error as open_bytes() does.
LineReader open_lines(const FoundLog& log, const LogProblemHandler& on_problem);

}  // namespace ddtool
