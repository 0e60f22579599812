#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logs/containers/mcap_format.hpp"

namespace ddtool {

static_assert(std::endian::native == std::endian::little, "MCAP's integers are copied as they lie in memory");

/// The same bytes as text.
inline std::string text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Reads the fields of a record from the front of its bytes (https://mcap.dev/spec, "Serialization"). Every take
/// function throws Error if the bytes end before the field does.
class McapFieldReader {
public:
    explicit McapFieldReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <std::unsigned_integral Integer>
    Integer take() {
        Integer value;
        std::memcpy(&value, take_bytes(sizeof(Integer)).data(), sizeof(Integer));
        return value;
    }
    std::string take_string();
    std::map<std::string, std::string> take_string_map();
    std::span<const std::byte> take_bytes(std::uint64_t count);
    /// The bytes that have not been taken yet.
    [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

private:
    std::span<const std::byte> rest_;
};

/// Bytes of records, appended field by field.
class McapFieldWriter {
public:
    template <std::unsigned_integral Integer>
    McapFieldWriter& put(Integer value) {
        return put_bytes(std::as_bytes(std::span(&value, 1)));
    }
    McapFieldWriter& put_string(std::string_view text);
    McapFieldWriter& put_bytes(std::span<const std::byte> bytes);
    /// Bytes, map or array: the length in four bytes, then the content.
    McapFieldWriter& put_array(std::span<const std::byte> content);
    McapFieldWriter& put_record_header(McapOpcode opcode, std::uint64_t content_bytes);
    McapFieldWriter& put_record(McapOpcode opcode, const McapFieldWriter& content);

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

private:
    std::vector<std::byte> bytes_;
};

}  // namespace ddtool
