#include "ros/stamp_bytes.hpp"

#include <bit>
#include <cstring>

namespace ddtool {
namespace {

constexpr std::size_t encapsulation_bytes = 4;
constexpr std::size_t stamp_bytes = 8;
constexpr std::int64_t ns_per_second = 1'000'000'000;

/// Whether the numbers of the message have the other byte order than this machine's.
bool is_swapped(std::span<const std::byte> message) {
    const bool is_little = (message[1] & std::byte{1}) != std::byte{0};
    return is_little != (std::endian::native == std::endian::little);
}

std::uint32_t swapped(std::uint32_t number) { return __builtin_bswap32(number); }

}  // namespace

std::optional<std::int64_t> first_stamp_ns(std::span<const std::byte> message) {
    if (message.size() < encapsulation_bytes + stamp_bytes) {
        return std::nullopt;
    }
    std::uint32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
    std::memcpy(&seconds, message.data() + encapsulation_bytes, sizeof seconds);
    std::memcpy(&nanoseconds, message.data() + encapsulation_bytes + sizeof seconds, sizeof nanoseconds);
    if (is_swapped(message)) {
        seconds = swapped(seconds);
        nanoseconds = swapped(nanoseconds);
    }
    return static_cast<std::int32_t>(seconds) * ns_per_second + nanoseconds;
}

void set_first_stamp(std::span<std::byte> message, std::int64_t stamp_ns) {
    if (message.size() < encapsulation_bytes + stamp_bytes) {
        return;
    }
    const std::int64_t below_ns = (stamp_ns % ns_per_second + ns_per_second) % ns_per_second;
    auto seconds = static_cast<std::uint32_t>((stamp_ns - below_ns) / ns_per_second);
    auto nanoseconds = static_cast<std::uint32_t>(below_ns);
    if (is_swapped(message)) {
        seconds = swapped(seconds);
        nanoseconds = swapped(nanoseconds);
    }
    std::memcpy(message.data() + encapsulation_bytes, &seconds, sizeof seconds);
    std::memcpy(message.data() + encapsulation_bytes + sizeof seconds, &nanoseconds, sizeof nanoseconds);
}

}  // namespace ddtool
