#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace ddtool {

/// CRC-32 of ISO 3309, as MCAP and zlib use it.
/// \param before the CRC of the bytes that precede these; 0 if there are none
inline std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// CRC-32C (Castagnoli; RFC 3720, appendix B.4), as TensorBoard's event files use it. Computed bit by bit, so it is for
/// small files only.
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
