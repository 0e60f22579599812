#pragma once

#include <filesystem>
#include <vector>

#include "ddtool/logs/log_problem.hpp"

namespace ddtool {

/// The storage files of a rosbag2 folder in the order of recording: those that its metadata.yaml lists or, if a
/// recorder that was killed left no metadata.yaml (which is reported), every MCAP and SQLite file in the order of their
/// numbers. The function does not check whether the listed files exist. Throws Error for a folder without metadata and
/// without such files, for metadata that cannot be read, and for metadata that list a file outside of the folder.
std::vector<std::filesystem::path> rosbag2_files(const std::filesystem::path& folder,
                                                 const LogProblemHandler& on_problem);

}  // namespace ddtool
