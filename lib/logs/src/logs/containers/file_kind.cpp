#include "logs/containers/file_kind.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace ddtool {
namespace {

using namespace std::string_view_literals;

struct FileKind {
    std::string_view start;
    std::string_view name;
};

constexpr std::array kinds = {
    FileKind{"\x89MCAP0\r\n"sv, "an MCAP file"},
    FileKind{mcap_start, "an MCAP file of another version, or one that is damaged or cut off"},
    FileKind{bag_start, "a ROS 1 bag"},
    FileKind{"SQLite f"sv, "an SQLite database"},
    FileKind{"BZh"sv, "a bzip2 file"},
    FileKind{"\x1f\x8b"sv, "a gzip file"},
    FileKind{"\x28\xb5\x2f\xfd"sv, "a zstd file (`zstd -d FILE -o NEW` unpacks it)"},
    FileKind{"\x04\x22\x4d\x18"sv, "an lz4 file"},
    FileKind{"PK\x03\x04"sv, "a zip file"},
    FileKind{"ULog\x01\x12\x35"sv, "a PX4 ULog"},
};

bool is_text(char byte) { return (byte >= ' ' && byte <= '~') || byte == '\t' || byte == '\n' || byte == '\r'; }

}  // namespace

std::string read_file_start(const std::filesystem::path& path, std::size_t size) {
    std::string start(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(size));
    start.resize(static_cast<std::size_t>(file.gcount()));
    return start;
}

std::string describe_file_start(std::span<const std::byte> start) {
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    if (text.empty()) {
        return "is empty";
    }
    const auto* const kind =
        std::ranges::find_if(kinds, [&](const FileKind& one) { return text.starts_with(one.start); });
    if (kind != kinds.end()) {
        return "starts like " + std::string(kind->name);
    }
    return std::ranges::all_of(text.substr(0, 8), is_text) ? "starts like a text file"
                                                           : "starts like no log that is known here";
}

}  // namespace ddtool
