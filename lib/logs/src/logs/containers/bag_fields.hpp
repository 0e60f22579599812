#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>

namespace ddtool {

/// The kinds of record in a ROS 1 bag, format 2.0 (http://wiki.ros.org/Bags/Format/2.0).
enum class BagOpcode : std::uint8_t {
    message = 0x02,
    bag_header = 0x03,
    index = 0x04,
    chunk = 0x05,
    chunk_info = 0x06,
    connection = 0x07,
};

/// The "name=value" fields of a record's header, or of a connection's data.
class BagFields {
public:
    BagFields() = default;
    /// Each field is its length in four bytes, then name, '=' and value. Throws Error if the bytes have another form.
    explicit BagFields(std::span<const std::byte> bytes);

    /// These functions throw Error naming the field if it does not exist or does not have the length of its type.
    [[nodiscard]] const std::string& text(const std::string& name) const;
    template <std::unsigned_integral Integer>
    [[nodiscard]] Integer number(const std::string& name) const {
        Integer value;
        std::memcpy(&value, sized(name, sizeof(Integer)).data(), sizeof(Integer));
        return value;
    }
    /// A time of four bytes of seconds and four bytes of nanoseconds, as nanoseconds.
    [[nodiscard]] std::int64_t time_ns(const std::string& name) const;
    [[nodiscard]] BagOpcode opcode() const { return BagOpcode{number<std::uint8_t>("op")}; }

private:
    [[nodiscard]] const std::string& sized(const std::string& name, std::size_t size) const;

    std::map<std::string, std::string> values_;
};

}  // namespace ddtool
