#include "assumed_inputs.hpp"

#include <system_error>

#include "ddtool/base/error.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

/// When the file was written; nullopt if there is no such file.
std::optional<std::filesystem::file_time_type> written(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure)) {
        return std::nullopt;
    }
    const auto time = std::filesystem::last_write_time(file, failure);
    return failure ? std::nullopt : std::optional(time);
}

}  // namespace

std::filesystem::path data_folder(const std::string& folder, bool named) {
    if (!named && !is_folder(folder)) {
        throw Error(folder + ": not there; ddtool build-dataset makes this data set, and --data names another");
    }
    if (!named) {
        log_info("no --data: the data set is " + folder);
    }
    return folder;
}

std::optional<std::filesystem::path> newest_model_in(const std::filesystem::path& folder) {
    std::optional<std::filesystem::path> newest;
    std::optional<std::filesystem::file_time_type> newest_time;
    std::error_code failure;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failure)) {
        const std::filesystem::path file = entry.path().extension() == ".pt" ? entry.path() : entry.path() / "best.pt";
        if (const auto time = written(file); time && (!newest_time || *time > *newest_time)) {
            newest = file;
            newest_time = time;
        }
    }
    return newest;
}

}  // namespace ddtool
