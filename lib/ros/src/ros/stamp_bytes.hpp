#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ddtool {

/// The stamp at the beginning of a CDR message, which either is a header or has one as its first field; nullopt if the
/// message is too short. Both byte orders.
std::optional<std::int64_t> first_stamp_ns(std::span<const std::byte> message);
/// Replaces that stamp, if there is one.
void set_first_stamp(std::span<std::byte> message, std::int64_t stamp_ns);

}  // namespace ddtool
