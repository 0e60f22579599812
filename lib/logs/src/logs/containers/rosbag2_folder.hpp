#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/log_file.hpp"

namespace ddtool {

/// The storage files of a rosbag2 folder in the order of recording: those that its metadata.yaml lists or, if a
/// recorder that was killed left no metadata.yaml (which is reported), every MCAP and SQLite file in the order of their
/// numbers, compressed or not. The function does not check whether the listed files exist. Throws Error for a folder
/// without metadata and without such files, or with files whose names differ in more than that number; for metadata
/// that cannot be read, and for metadata that list a file outside of the folder.
std::vector<LogFile> rosbag2_files(const std::filesystem::path& folder, const LogProblemHandler& on_problem);

/// Whether the files are called like the parts of one recording, NAME_0.mcap, NAME_1.mcap and so on.
bool are_parts_of_one_recording(const std::vector<LogFile>& files);

/// Whether a text that begins like this is a metadata.yaml.
bool is_rosbag2_metadata(std::string_view start);

/// The same for a recording in a tar archive: of the storage files, those that the metadata among them list, in this
/// order, or, without metadata, all in the order of their numbers. Throws Error as above.
/// \param files the storage files, all in one folder of the archive
/// \param metadata its metadata.yaml; its entry is empty if there is none
std::vector<LogFile> rosbag2_files(std::vector<LogFile> files, const LogFile& metadata);

}  // namespace ddtool
