#include "logs/containers/rosbag2_folder.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/file_kind.hpp"

namespace ddtool {
namespace {

namespace fs = std::filesystem;

/// The path of a storage file that the metadata list. Before version 4 of the metadata, paths began with the name of
/// the folder itself. If a file was compressed as a whole, somebody may have decompressed it, so that the name has lost
/// its last extension.
fs::path storage_file(const fs::path& folder, const std::string& name) {
    const fs::path path = fs::path(name).lexically_normal();
    if (path.empty() || path.is_absolute() || *path.begin() == "..") {
        throw Error((folder / "metadata.yaml").string() + ": names '" + name +
                    "', which lies outside of the folder; expected a file in it");
    }
    for (const fs::path& known : {path, path.filename(), path.parent_path() / path.stem()}) {
        std::error_code unusable;  // for example a name that is too long; opening the file gives the error
        if (fs::exists(folder / known, unusable)) {
            return folder / known;
        }
    }
    return folder / path;
}

std::vector<std::string> names_in(const fs::path& metadata) {
    try {
        const YAML::Node root = YAML::LoadFile(metadata.string());
        const YAML::Node names = root["rosbag2_bagfile_information"]["relative_file_paths"];
        return names.as<std::vector<std::string>>();
    } catch (const YAML::Exception& error) {
        throw Error(metadata.string() + ": cannot read: " + error.what() +
                    "; expected rosbag2_bagfile_information with relative_file_paths");
    }
}

/// Orders files by their number: NAME_2 before NAME_10.
bool recorded_before(const fs::path& a, const fs::path& b) {
    const std::string name_a = a.filename().string();
    const std::string name_b = b.filename().string();
    return std::pair(name_a.size(), name_a) < std::pair(name_b.size(), name_b);
}

std::vector<fs::path> files_without_metadata(const fs::path& folder, const LogProblemHandler& on_problem) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string start = entry.is_regular_file() ? read_file_start(entry.path(), sqlite_magic.size()) : "";
        if (start.starts_with(mcap_start) || start.starts_with(sqlite_magic)) {
            files.push_back(entry.path());
        }
    }
    if (files.empty()) {
        throw Error(folder.string() +
                    ": is a folder without a log; expected that of rosbag2: metadata.yaml, MCAP or .db3 files");
    }
    std::ranges::sort(files, recorded_before);
    on_problem({folder.string() + ": has no metadata.yaml: the recorder was stopped hard, or is still at it; " +
                std::to_string(files.size()) + " files are read in the order of their names"});
    return files;
}

}  // namespace

std::vector<fs::path> rosbag2_files(const fs::path& folder, const LogProblemHandler& on_problem) {
    const fs::path metadata = folder / "metadata.yaml";
    if (!fs::exists(metadata)) {
        return files_without_metadata(folder, on_problem);
    }
    std::vector<fs::path> files;
    for (const std::string& name : names_in(metadata)) {
        files.push_back(storage_file(folder, name));
    }
    if (files.empty()) {
        throw Error(metadata.string() + ": names no files; expected relative_file_paths");
    }
    return files;
}

}  // namespace ddtool
