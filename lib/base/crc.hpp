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

}  // namespace ddtool
