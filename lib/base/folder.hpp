#pragma once

#include <filesystem>

namespace ddtool {

/// The folder, made with its parents where it is not there. Throws OutputError naming it and the system's reason.
std::filesystem::path made_folder(std::filesystem::path folder);

}  // namespace ddtool
