#include "system/fingerprint.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <vector>

namespace ddtool {

Fingerprint& Fingerprint::add(std::string_view bytes) {
    for (const char byte : bytes) {
        state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return *this;
}

Fingerprint& Fingerprint::add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) {
        state_ = (state_ ^ ((bits >> shift) & 0xffU)) * 0x100000001b3U;
    }
    return *this;
}

std::string Fingerprint::hex() const {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(state_));
    return text.data();
}

std::string file_fingerprint(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return "unreadable";
    }
    Fingerprint fingerprint;
    std::vector<char> block(1U << 20U);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
        fingerprint.add({block.data(), static_cast<std::size_t>(file.gcount())});
    }
    return fingerprint.hex();
}

}  // namespace ddtool
