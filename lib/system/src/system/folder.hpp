#pragma once

#include <filesystem>

namespace ddtool {

/// The folder, made with its parents where it is not there. Throws OutputError naming it and the system's reason.
std::filesystem::path made_folder(std::filesystem::path folder);

/// Never throws: what cannot be looked at, such as a name too long for the file system, is none; opening it says why.
bool is_folder(const std::filesystem::path& path) noexcept;

}  // namespace ddtool
