#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "logs/messages/ros_messages.hpp"

namespace ddtool {

/// Serialises a message that has a type_name as ROS 2 does: the encapsulation header, then XCDR version 1 (OMG
/// DDS-XTYPES 1.3, 7.4.1).
template <typename Message>
std::vector<std::byte> encode_cdr(const Message& message, std::endian endian = std::endian::little);

/// Undoes encode_cdr(), for either byte order, and also reads plain XCDR version 2 (the same, but nothing is aligned to
/// more than four bytes, and sequences of other than numbers have their length in front). Bytes after the message are
/// ignored. Returns nullopt if the bytes are not such a message. Memory stays in proportion to the number of bytes,
/// whatever lengths they declare.
template <typename Message>
std::optional<Message> decode_cdr(std::span<const std::byte> data);

/// The name of the encapsulation of a message that decode_cdr() does not read: parameter lists, and XCDR version 2 with
/// headers. Empty if it is none of these.
std::string unknown_cdr(std::span<const std::byte> data);

/// The same for ROS 1's serialisation (http://wiki.ros.org/msg, little endian, no padding, headers with a sequence
/// number).
template <typename Message>
std::optional<Message> decode_ros1(std::span<const std::byte> data);

}  // namespace ddtool
