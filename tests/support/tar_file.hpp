#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace ddtool::test {

/// One file of a tar archive (POSIX ustar): its header and content, padded to blocks of 512 bytes.
inline std::string tar_entry(const std::string& name, const std::string& content, char type = '0') {
    std::string header(512, '\0');
    header.replace(0, name.size(), name);
    header.replace(100, 7, "0000644");
    std::string size(13, '\0');
    std::snprintf(size.data(), size.size(), "%011zo", content.size());
    header.replace(124, 12, size.substr(0, 12));
    header[156] = type;
    header.replace(257, 8, std::string("ustar\00000", 8));
    header.replace(148, 8, 8, ' ');
    unsigned sum = 0;
    for (const char byte : header) {
        sum += static_cast<unsigned char>(byte);
    }
    std::string checksum(8, '\0');
    std::snprintf(checksum.data(), checksum.size(), "%06o", sum);
    header.replace(148, 7, checksum.substr(0, 7));
    return header + content + std::string((512 - content.size() % 512) % 512, '\0');
}

/// A whole archive, with a folder at its beginning, as tar writes it.
inline std::string tar_archive(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string archive = tar_entry("folder/", "", '5');
    for (const auto& [name, content] : files) {
        archive += tar_entry(name, content);
    }
    return archive + std::string(1024, '\0');
}

}  // namespace ddtool::test
