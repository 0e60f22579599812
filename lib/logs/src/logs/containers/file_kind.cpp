#include "logs/containers/file_kind.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text.hpp"

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
    FileKind{"\x28\xb5\x2f\xfd"sv, "a zstd file"},
    FileKind{"\x04\x22\x4d\x18"sv, "an lz4 file"},
    FileKind{"\xfd\x37zXZ"sv, "an xz file (`xz -dk FILE` unpacks it)"},
    FileKind{"7z\xbc\xaf\x27\x1c"sv, "a 7-Zip archive; unpack it and give the log in it"},
    FileKind{"PK\x03\x04"sv, "a zip archive; unpack it (`unzip FILE`) and give the log in it"},
    FileKind{"#ROSRECORD V"sv, "a ROS bag of version 1; `rosbag fix OLD.bag NEW.bag` renews it"},
    FileKind{"\x89HDF\r\n\x1a\n"sv, "an HDF5 file, which is no log of messages"},
    FileKind{"\x93NUMPY"sv, "a NumPy array, which is no log of messages"},
    FileKind{"ULog\x01\x12\x35"sv, "a PX4 ULog"},
    FileKind{"\x89PNG"sv, "a PNG picture, which has no scans; a map is made from the log of a drive"},
    FileKind{"\xff\xd8\xff"sv, "a JPEG picture, which has no scans; a map is made from the log of a drive"},
    FileKind{"P5\n"sv, "a PGM picture or map, which has no scans; a map is made from the log of a drive"},
    FileKind{"P2\n"sv, "a PGM picture or map, which has no scans; a map is made from the log of a drive"},
    FileKind{"P5 "sv, "a PGM picture or map, which has no scans; a map is made from the log of a drive"},
    FileKind{"%PDF"sv, "a PDF document"},
    FileKind{"ply\n"sv, "a point cloud (PLY), which is no log; give the log that it was made from"},
    FileKind{"ply\r"sv, "a point cloud (PLY), which is no log; give the log that it was made from"},
    FileKind{"# .PCD"sv, "a point cloud (PCD), which is no log; give the log that it was made from"},
    FileKind{"LASF"sv, "a point cloud (LAS), which is no log; give the log that it was made from"},
    FileKind{"\xd4\xc3\xb2\xa1"sv,
             "a network capture (pcap); the lidar's driver turns it into scans, which can be recorded"},
    FileKind{"\x0a\x0d\x0d\x0a"sv,
             "a network capture (pcapng); the lidar's driver turns it into scans, which can be recorded"},
};

bool is_text(char byte) { return (byte >= ' ' && byte <= '~') || byte == '\t' || byte == '\n' || byte == '\r'; }

/// The first line that is neither empty nor a comment.
std::string_view first_line(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        if (!line.empty() && line.front() != '#') {
            return line;
        }
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return {};
}

/// How many words the line has, and whether all but the first `names` of them are numbers.
std::pair<std::size_t, bool> count_numbers(std::string_view line, std::size_t names) {
    std::size_t words = 0;
    bool are_numbers = true;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        are_numbers = are_numbers && (words < names || parse_number(word));
        ++words;
    }
    return {words, are_numbers};
}

/// What a text without lines of CARMEN is.
std::string_view name_of_text(std::string_view text) {
    const std::string_view line = first_line(text);
    const bool is_laser_or_odometry = line.starts_with("L ") || line.starts_with("O ");
    if (const auto [words, are_numbers] = count_numbers(line, 1); is_laser_or_odometry && words >= 5 && are_numbers) {
        return "a laser log with the lines L and O, as in CMU's course 16-831; docs/formats/logs.md says how to turn "
               "it "
               "into a CARMEN log";
    }
    if (const auto [words, are_numbers] = count_numbers(line, 0); words == 8 && are_numbers) {
        return "a trajectory (TUM: time, position, rotation), which has no scans; `ddtool score` compares it with "
               "another";
    }
    if (text.find("\nDATA ascii") != text.npos || text.find("\nDATA binary") != text.npos) {
        return "a point cloud (PCD), which is no log; give the log that it was made from";
    }
    if (line.starts_with("image:") || text.find("\noccupied_thresh:") != text.npos) {
        return "the description of a map (YAML), which has no scans; a map is made from the log of a drive";
    }
    if (std::ranges::count(line, ',') > 1 || std::ranges::count(line, ';') > 1) {
        return "a table (CSV); its scans have to be written as messages of ROS or as a CARMEN log first";
    }
    return "a text file";
}

}  // namespace

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
    return std::ranges::all_of(text.substr(0, 8), is_text) ? "starts like " + std::string(name_of_text(text))
                                                           : "starts like no log that is known here";
}

}  // namespace ddtool
