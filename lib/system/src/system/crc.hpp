#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace ddtool {

/// CRC-32 of ISO 3309, the one of MCAP and zlib. `before`: the CRC of the bytes that come before these.
inline std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// CRC-32C (Castagnoli; RFC 3720, appendix B.4), the one of TensorBoard's event files. Bit by bit, for small files.
constexpr std::uint32_t crc32c_of(std::span<const std::byte> bytes) {
    constexpr std::uint32_t reversed_polynomial = 0x82f63b78U;
    std::uint32_t crc = 0xffffffffU;
    for (const std::byte byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1U) ^ ((crc & 1U) * reversed_polynomial);
        }
    }
    return ~crc;
}

}  // namespace ddtool
