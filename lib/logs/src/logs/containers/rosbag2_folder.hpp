#pragma once

#include <filesystem>
#include <vector>

#include "ddtool/logs/log_problem.hpp"

namespace ddtool {

/// The storage files of a rosbag2 folder in the order of recording: those that its metadata.yaml names, or, where a
/// recorder that was stopped hard left none (which is reported), every MCAP and SQLite file by number. Whether they are
/// there is not looked at. Throws Error for a folder without either, for metadata that cannot be read, and for metadata
/// that name a file outside of the folder.
std::vector<std::filesystem::path> rosbag2_files(const std::filesystem::path& folder,
                                                 const LogProblemHandler& on_problem);

}  // namespace ddtool
