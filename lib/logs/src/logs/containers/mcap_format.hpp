#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ddtool {

/// At the start and the end of every file: 0x89 "MCAP" version "\r\n".
inline constexpr std::array<std::byte, 8> mcap_magic = {std::byte{0x89}, std::byte{'M'}, std::byte{'C'},
                                                        std::byte{'A'},  std::byte{'P'}, std::byte{'0'},
                                                        std::byte{'\r'}, std::byte{'\n'}};

/// The first byte of a record (https://mcap.dev/spec, "Records"). A length of eight bytes and the content follow.
enum class McapOpcode : std::uint8_t {
    header = 0x01,
    footer = 0x02,
    schema = 0x03,
    channel = 0x04,
    message = 0x05,
    chunk = 0x06,
    message_index = 0x07,
    chunk_index = 0x08,
    statistics = 0x0B,
    summary_offset = 0x0E,
    data_end = 0x0F,
};

/// Opcode and length.
inline constexpr std::size_t mcap_record_header_bytes = 9;

/// The reader's own limit: no record or chunk that must be held in memory may be larger.
inline constexpr std::uint64_t mcap_max_held_bytes = std::uint64_t{1} << 30;

}  // namespace ddtool
