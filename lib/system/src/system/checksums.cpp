#include "system/checksums.hpp"

#include <sha2.h>

#include <array>
#include <cstdint>
#include <sstream>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

/// The checksum that the list has for a file; empty if the list does not name the file.
std::string listed_checksum(const std::string& list, const std::string& name) {
    std::istringstream lines(list);
    for (std::string sum, file; lines >> sum >> file;) {
        if (file == name || file == "*" + name) {  // sha256sum puts a star before files read as binary
            return sum;
        }
    }
    return {};
}

}  // namespace

std::string sha256_of(std::string_view bytes) {
    std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
    SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), text.data());
    return text.data();
}

void expect_listed_checksum(const std::filesystem::path& file) {
    const std::filesystem::path list = file.parent_path() / "SHA256SUMS";
    if (!std::filesystem::exists(list)) {
        return;
    }
    const std::string expected = listed_checksum(read_file(list), file.filename().string());
    if (!expected.empty() && sha256_of(read_file(file)) != expected) {
        throw Error(file.string() + ": damaged or another file: its SHA-256 is not the one in " + list.string());
    }
}

}  // namespace ddtool
