#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "temporary_folder.hpp"

namespace ddtool::fuzz {

/// A file with that name and content, which is valid until the next call with the same name. It is not written by
/// write_file(): nothing here needs to survive a crash, and a rename for each of a million inputs would take time.
inline std::filesystem::path input_file(std::span<const char> content, const std::string& name) {
    static const test::TemporaryFolder folder;
    std::filesystem::path path = folder / name;
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
    return path;
}

}  // namespace ddtool::fuzz
