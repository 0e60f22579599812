#include "system/folder.hpp"

#include <system_error>

#include "system/atomic_file.hpp"

namespace ddtool {

std::filesystem::path made_folder(std::filesystem::path folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw OutputError(folder.string() + ": cannot create the folder: " + failure.message());
    }
    return folder;
}

bool is_folder(const std::filesystem::path& path) noexcept {
    std::error_code unusable;
    return std::filesystem::is_directory(path, unusable);
}

}  // namespace ddtool
