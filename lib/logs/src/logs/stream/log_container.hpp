#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// What a log comes in.
enum class LogContainer { mcap, ros1_bag, db3, rosbag2_folder, carmen };

/// "MCAP", "ROS 1 bag" and so on.
std::string_view name_of(LogContainer container);

/// Told apart by content, not by name. Throws Error naming the file for what is none of these or cannot be opened.
LogContainer container_of(const std::filesystem::path& path);

/// The messages of any container but CARMEN, whose lines are no messages of this kind. Throws Error as the containers'
/// readers do.
std::unique_ptr<MessageSource> open_messages(LogContainer container, const std::filesystem::path& path,
                                             LogProblemHandler on_problem);

}  // namespace ddtool
