#include "system/row_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {

void for_each_row(const std::filesystem::path& path, std::string_view expected,
                  const std::function<bool(std::string_view line)>& take) {
    errno = 0;
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path)) {
        throw Error(path.string() + ": cannot open: " + std::strerror(errno == 0 ? EISDIR : errno));
    }
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') {
            continue;
        }
        if (!take(line)) {
            throw Error(path.string() + ":" + std::to_string(number) + ": expected " + std::string(expected));
        }
    }
}

}  // namespace ddtool
