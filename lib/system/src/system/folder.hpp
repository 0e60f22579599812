#pragma once

#include <filesystem>

namespace ddtool {

/// Creates the folder and its parents if they do not exist, and returns it. Throws OutputError naming the folder and
/// the system's reason if this fails.
std::filesystem::path made_folder(std::filesystem::path folder);

/// Whether the path is a folder. Never throws: for a path that cannot be examined, such as a name that is too long for
/// the file system, it returns false, and whoever opens the path gets the reason.
bool is_folder(const std::filesystem::path& path) noexcept;

}  // namespace ddtool
