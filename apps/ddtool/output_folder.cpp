#include "output_folder.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "system/atomic_file.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

std::filesystem::path numbered(const std::string& name, std::size_t number) {
    return number == 1 ? name : name + "-" + std::to_string(number);
}

/// Whether anything has this name, even a link that leads nowhere.
bool is_taken(const std::filesystem::path& path) {
    std::error_code unusable;
    return std::filesystem::exists(std::filesystem::symlink_status(path, unusable));
}

/// Returns false if the name is taken. Throws OutputError if the folder cannot be created for another reason.
bool create(const std::filesystem::path& folder) {
    std::error_code failure;
    if (std::filesystem::create_directory(folder, failure)) {
        return true;
    }
    if (!is_taken(folder)) {
        throw OutputError(folder.string() + ": cannot create the folder: " + failure.message());
    }
    return false;
}

}  // namespace

OutputFolder::OutputFolder(const std::string& given, const std::string& name, const Unfinished& unfinished)
    : path_(given) {
    if (!given.empty()) {
        return;
    }
    for (std::size_t number = 1; !created_; ++number) {
        path_ = numbered(name, number);
        created_ = create(path_);
        if (!created_ && unfinished && is_folder(path_) && unfinished(path_)) {
            log_info("no --out: going on with what was stopped in the folder " + path_.string());
            return;
        }
    }
    log_info("no --out: the results go to the new folder " + path_.string());
}

OutputFolder::~OutputFolder() {
    if (created_) {
        std::error_code not_empty;  // then it stays
        std::filesystem::remove(path_, not_empty);
    }
}

std::string name_of_results(const std::string& log) {
    std::filesystem::path name = std::filesystem::path(log).lexically_normal();
    const bool is_metadata = name.filename() == "metadata.yaml";  // which stands for its folder
    name = name.has_filename() && !is_metadata ? name.filename() : name.parent_path().filename();
    constexpr std::array<std::string_view, 5> packed{".gz", ".bz2", ".zst", ".zstd", ".lz4"};
    if (std::ranges::count(packed, name.extension().string()) > 0) {
        name = name.stem();
    }
    if (!is_metadata && !is_folder(log)) {
        name = name.stem();
    }
    return name.empty() || name == "-" || name == "." || name == ".." ? "slam" : name.string();
}

}  // namespace ddtool
