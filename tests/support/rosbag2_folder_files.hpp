#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "db3_file.hpp"
#include "recording.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::test {

inline void write_metadata(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    std::string yaml = "rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:\n";
    for (const std::string& name : names) {
        yaml += "    - " + name + "\n";
    }
    write_file(folder / "metadata.yaml", yaml);
}

/// Splits a recording into parts of equal length, part_0 and so on; `write` writes each of them.
inline void write_folder(const std::filesystem::path& folder, const Recording& recording, std::size_t parts,
                         const std::function<void(const std::filesystem::path&, const Recording&)>& write) {
    std::filesystem::create_directory(folder);
    std::vector<std::string> names;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto at = [&](std::size_t index) {
            return recording.begin() + static_cast<std::ptrdiff_t>(recording.size() * index / parts);
        };
        names.push_back("part_" + std::to_string(part));
        write(folder / names.back(), Recording(at(part), at(part + 1)));
    }
    write_metadata(folder, names);
}

inline void write_db3_folder(const std::filesystem::path& folder, const Recording& recording, std::size_t parts) {
    write_folder(folder, recording, parts, [](const auto& path, const Recording& part) { write_db3(path, part); });
}

inline void write_mcap_folder(const std::filesystem::path& folder, const Recording& recording, std::size_t parts) {
    write_folder(folder, recording, parts, [](const auto& path, const Recording& part) { write_mcap(path, part); });
}

}  // namespace ddtool::test
