#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The file formats of logs.
enum class LogContainer { mcap, ros1_bag, db3, rosbag2_folder, carmen };

/// "MCAP", "ROS 1 bag" and so on.
std::string_view name_of(LogContainer container);

/// The format of a log, recognised by content, not by name. Throws Error naming the file if it has none of these
/// formats or cannot be opened.
LogContainer container_of(const std::filesystem::path& path);

/// The messages of a log in any format except CARMEN, whose lines are not messages with a type and an encoding. Throws
/// Error as the readers of the formats do.
std::unique_ptr<MessageSource> open_messages(LogContainer container, const std::filesystem::path& path,
                                             LogProblemHandler on_problem);

}  // namespace ddtool
