#include "logs/containers/rosbag2_folder.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/file_kind.hpp"

namespace ddtool {
namespace {

namespace fs = std::filesystem;

/// The path of a storage file that the metadata list. Before version 4 of the metadata, paths began with the name of
/// the folder itself. If a file was compressed as a whole, somebody may have decompressed it, so that the name has lost
/// its last extension, or the other way round.
fs::path storage_file(const fs::path& folder, const std::string& name) {
    const fs::path path = fs::path(name).lexically_normal();
    if (path.empty() || path.is_absolute() || *path.begin() == "..") {
        throw Error((folder / "metadata.yaml").string() + ": names '" + name +
                    "', which lies outside of the folder; expected a file in it");
    }
    const fs::path packed = path.string() + ".zstd";
    for (const fs::path& known : {path, path.filename(), path.parent_path() / path.stem(), packed}) {
        std::error_code unusable;  // for example a name that is too long; opening the file gives the error
        if (fs::exists(folder / known, unusable)) {
            return folder / known;
        }
    }
    return folder / path;
}

std::vector<std::string> names_in(const LogFile& metadata) {
    constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;
    std::vector<std::byte> bytes;
    open_bytes(metadata, {}).append_to(bytes, most_bytes);
    try {
        const YAML::Node root = YAML::Load(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        const YAML::Node names = root["rosbag2_bagfile_information"]["relative_file_paths"];
        return names.as<std::vector<std::string>>();
    } catch (const YAML::Exception& error) {
        throw Error(metadata.name() + ": cannot read: " + error.what() +
                    "; expected rosbag2_bagfile_information with relative_file_paths");
    }
}

std::string start_of(const fs::directory_entry& entry) {
    if (!entry.is_regular_file()) {
        return "";
    }
    try {
        ByteSource bytes = open_bytes({entry.path(), ""}, {});
        const auto start = bytes.start(sqlite_magic.size());
        return {reinterpret_cast<const char*>(start.data()), start.size()};
    } catch (const Error&) {
        return "";  // a file that cannot be read is none of the recording
    }
}

/// Orders files by their number: NAME_2 before NAME_10.
bool recorded_before(const fs::path& a, const fs::path& b) {
    const std::string name_a = a.filename().string();
    const std::string name_b = b.filename().string();
    return std::pair(name_a.size(), name_a) < std::pair(name_b.size(), name_b);
}

/// The part of the name of a storage file that all parts of a recording have: NAME of NAME_3.mcap or NAME_3.db3.zstd;
/// the whole name if it has no number.
std::string name_of_recording(const fs::path& file) {
    const std::string name = file.filename().string();
    const std::string stem = name.substr(0, name.find('.', name.find_last_of('_') + 1));
    const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
    const bool is_numbered = digits > 0 && digits < stem.size() && stem[digits - 1] == '_';
    return is_numbered ? stem.substr(0, digits) : name;
}

std::vector<LogFile> files_without_metadata(const fs::path& folder, const LogProblemHandler& on_problem) {
    std::vector<fs::path> files;
    std::vector<fs::path> bags;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string start = start_of(entry);
        if (start.starts_with(mcap_start) || start.starts_with(sqlite_magic)) {
            files.push_back(entry.path());
        } else if (start.starts_with(bag_start)) {
            bags.push_back(entry.path());
        }
    }
    if (files.empty()) {
        throw Error(folder.string() +
                    ": is a folder without a log; expected that of rosbag2: metadata.yaml, MCAP or .db3 " + "files" +
                    (bags.empty() ? "" : "; it has ROS 1 bags, which are given one by one: " + bags[0].string()));
    }
    std::ranges::sort(files, recorded_before);
    if (const auto other = std::ranges::find_if(
            files, [&](const fs::path& file) { return name_of_recording(file) != name_of_recording(files[0]); });
        other != files.end()) {
        throw Error(folder.string() + ": has no metadata.yaml, and its " + std::to_string(files.size()) +
                    " files are not parts of one recording by their names (" + files[0].filename().string() + ", " +
                    other->filename().string() + "); give one of them");
    }
    on_problem({folder.string() + ": has no metadata.yaml: the recorder was stopped hard, or is still at it; " +
                std::to_string(files.size()) + " files are read in the order of their names"});
    std::vector<LogFile> logs;
    for (const fs::path& file : files) {
        logs.push_back({file, ""});
    }
    return logs;
}

}  // namespace

bool are_parts_of_one_recording(const std::vector<LogFile>& files) {
    return std::ranges::all_of(files, [&](const LogFile& file) {
        return name_of_recording(file.entry) == name_of_recording(files.front().entry);
    });
}

bool is_rosbag2_metadata(std::string_view start) {
    return start.starts_with("rosbag2_bagfile_information:") ||
           start.find("\nrosbag2_bagfile_information:") != start.npos;
}

std::vector<LogFile> rosbag2_files(const fs::path& folder, const LogProblemHandler& on_problem) {
    const fs::path metadata = folder / "metadata.yaml";
    if (!fs::exists(metadata)) {
        return files_without_metadata(folder, on_problem);
    }
    std::vector<LogFile> files;
    for (const std::string& name : names_in({metadata, ""})) {
        files.push_back({storage_file(folder, name), ""});
    }
    if (files.empty()) {
        throw Error(metadata.string() + ": names no files; expected relative_file_paths");
    }
    return files;
}

std::vector<LogFile> rosbag2_files(std::vector<LogFile> files, const LogFile& metadata) {
    std::ranges::sort(files, recorded_before, &LogFile::entry);
    if (metadata.entry.empty()) {
        return files;
    }
    std::vector<LogFile> listed;
    for (const std::string& name : names_in(metadata)) {
        const fs::path path(name);
        const auto found = std::ranges::find_if(files, [&](const LogFile& file) {
            const fs::path known = fs::path(file.entry).filename();
            return known == path.filename() || known == path.stem() || known == path.filename().string() + ".zstd";
        });
        listed.push_back(found == files.end() ? LogFile{metadata.path, name} : *found);
    }
    return listed;
}

}  // namespace ddtool
