#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include <array>
#include <bit>
#include <type_traits>

#include "logs/messages/ros_codec.hpp"

namespace ddtool {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::int64_t ns_per_s = 1'000'000'000;
constexpr std::size_t encapsulation_bytes = 4;

template <typename Value>
concept Scalar = std::is_arithmetic_v<Value>;

class CdrWriter {
public:
    explicit CdrWriter(std::endian endian)
        : cdr_(buffer_, endian == std::endian::big ? Cdr::BIG_ENDIANNESS : Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) {
        cdr_.serialize_encapsulation();
    }
    void operator()(const auto&... values) { (write(values), ...); }
    std::vector<std::byte> take() {
        const auto* begin = reinterpret_cast<const std::byte*>(cdr_.getBufferPointer());
        return {begin, begin + cdr_.getSerializedDataLength()};
    }

private:
    void write(const auto& message) { message.fields(message, *this); }
    void write(const Scalar auto& value) {
        align(sizeof value);
        cdr_.serialize(value);
    }
    void write(const std::string& text) {
        align(sizeof(std::uint32_t));  // the length, which precedes the text
        cdr_.serialize(text);
    }
    void write(const RosTime& time) {
        const std::int64_t below = (time.ns % ns_per_s + ns_per_s) % ns_per_s;
        write(static_cast<std::int32_t>((time.ns - below) / ns_per_s));
        write(static_cast<std::uint32_t>(below));
    }
    template <Scalar Value, std::size_t size>
    void write(const std::array<Value, size>& values) {
        write_all(values);
    }
    template <typename Value>
    void write(const std::vector<Value>& values) {
        write(static_cast<std::uint32_t>(values.size()));
        if constexpr (Scalar<Value>) {
            write_all(values);
        } else {
            for (const Value& value : values) {
                write(value);
            }
        }
    }
    void write_all(const auto& values) {
        if (!values.empty()) {
            align(sizeof values[0]);
            cdr_.serializeArray(values.data(), values.size());
        }
    }
    /// Writes padding. fast-cdr itself skips these bytes and leaves in them what the memory held, but the same message
    /// must always give the same bytes.
    void align(std::size_t size) {
        while ((cdr_.getSerializedDataLength() - encapsulation_bytes) % size != 0) {
            cdr_.serialize(std::uint8_t{0});
        }
    }

    FastBuffer buffer_;
    Cdr cdr_;
};

/// The representation identifier of a message (DDS-XTYPES 1.3, 7.6.3.1.2); nullopt if it is too short for one.
std::optional<unsigned> representation_of(std::span<const std::byte> data) {
    return data.size() < encapsulation_bytes
               ? std::nullopt
               : std::optional(256U * std::to_integer<unsigned>(data[0]) + std::to_integer<unsigned>(data[1]));
}

/// Whether the message is in PLAIN_CDR2, in either byte order.
bool is_plain_cdr2(std::span<const std::byte> data) {
    const unsigned id = representation_of(data).value_or(0);
    return id == 0x0006U || id == 0x0007U;
}

/// Reads the fields of a message. Throws fast-cdr's exceptions if the data end too early.
class CdrReader {
public:
    /// The cast is safe: fast-cdr has no buffer of const bytes, but does not write to this one.
    explicit CdrReader(std::span<const std::byte> data)
        : is_cdr2_(is_plain_cdr2(data)),
          is_big_endian_(is_cdr2_ && data[1] == std::byte{6}),
          content_(data.subspan(is_cdr2_ ? encapsulation_bytes : 0)),
          buffer_(const_cast<char*>(reinterpret_cast<const char*>(content_.data())),  // NOLINT(*-const-cast)
                  content_.size()),
          cdr_(buffer_, is_big_endian_ ? Cdr::BIG_ENDIANNESS : Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) {
        if (!is_cdr2_) {
            cdr_.read_encapsulation();
        }
    }
    void operator()(auto&... values) { (read(values), ...); }

private:
    void read(auto& message) { message.fields(message, *this); }
    template <Scalar Value>
    void read(Value& value) {
        if (sizeof(Value) == 8 && is_cdr2_) {
            read_halves(value);
        } else {
            cdr_.deserialize(value);
        }
    }
    /// fast-cdr 1 aligns eight bytes to eight, XCDR version 2 to four.
    void read_halves(auto& value) {
        std::array<std::uint32_t, 2> halves{};
        cdr_.deserialize(halves[is_big_endian_ ? 1 : 0]);
        cdr_.deserialize(halves[is_big_endian_ ? 0 : 1]);
        if constexpr (sizeof value == sizeof halves) {
            value = std::bit_cast<std::decay_t<decltype(value)>>(halves);
        }
    }
    void read(std::string& text) { cdr_.deserialize(text); }
    void read(RosTime& time) {
        std::int32_t seconds = 0;
        std::uint32_t nanoseconds = 0;
        cdr_.deserialize(seconds);
        cdr_.deserialize(nanoseconds);
        time.ns = seconds * ns_per_s + nanoseconds;
    }
    template <Scalar Value, std::size_t size>
    void read(std::array<Value, size>& values) {
        read_all(values);
    }
    /// The count may be damaged and huge. Numbers are therefore read only if the remaining bytes suffice for them, and
    /// other elements are read one by one.
    template <typename Value>
    void read(std::vector<Value>& values) {
        std::uint32_t count = 0;
        if (!Scalar<Value> && is_cdr2_) {
            cdr_.deserialize(count);  // the length in bytes, which comes first here
        }
        cdr_.deserialize(count);
        if constexpr (Scalar<Value>) {
            if (count > remaining() / sizeof(Value)) {
                throw eprosima::fastcdr::exception::NotEnoughMemoryException("sequence beyond the end");
            }
            values.resize(count);
            read_all(values);
        } else {
            for (std::uint32_t i = 0; i < count; ++i) {
                read(values.emplace_back());
            }
        }
    }
    void read_all(auto& values) {
        if (sizeof values[0] == 8 && is_cdr2_) {
            for (auto& value : values) {
                read(value);
            }
        } else {
            cdr_.deserializeArray(values.data(), values.size());
        }
    }
    std::size_t remaining() {
        return buffer_.getBufferSize() - static_cast<std::size_t>(cdr_.getCurrentPosition() - buffer_.getBuffer());
    }

    bool is_cdr2_;
    bool is_big_endian_;
    std::span<const std::byte> content_;
    FastBuffer buffer_;
    Cdr cdr_;
};

}  // namespace

std::string unknown_cdr(std::span<const std::byte> data) {
    switch (representation_of(data).value_or(0)) {
        case 0x0002:
        case 0x0003:
            return "PL_CDR (XCDR version 1 with parameter lists)";
        case 0x0008:
        case 0x0009:
            return "D_CDR2 (XCDR version 2 with headers of length)";
        case 0x000A:
        case 0x000B:
            return "PL_CDR2 (XCDR version 2 with parameter lists)";
        default:
            return "";
    }
}

template <typename Message>
std::vector<std::byte> encode_cdr(const Message& message, std::endian endian) {
    CdrWriter writer(endian);
    writer(message);
    return writer.take();
}

template <typename Message>
std::optional<Message> decode_cdr(std::span<const std::byte> data) {
    if (!unknown_cdr(data).empty()) {
        return std::nullopt;
    }
    try {
        Message message;
        CdrReader reader(data);
        reader(message);
        return message;
    } catch (const eprosima::fastcdr::exception::Exception&) {
        return std::nullopt;
    }
}

#define DDTOOL_CDR(Message)                                                  \
    template std::vector<std::byte> encode_cdr(const Message&, std::endian); \
    template std::optional<Message> decode_cdr(std::span<const std::byte>);
DDTOOL_CDR(RosTFMessage)
DDTOOL_CDR(RosLaserScan)
DDTOOL_CDR(RosImu)
DDTOOL_CDR(RosMultiEchoLaserScan)
DDTOOL_CDR(RosPointCloud2)
DDTOOL_CDR(RosOdometry)
DDTOOL_CDR(RosPoseStamped)
DDTOOL_CDR(RosTwistStamped)
DDTOOL_CDR(RosTwistWithCovarianceStamped)
DDTOOL_CDR(RosPoseArray)
DDTOOL_CDR(RosPath)
DDTOOL_CDR(RosOccupancyGrid)
DDTOOL_CDR(RosParticleSnapshot)
DDTOOL_CDR(RosFloat64MultiArray)
DDTOOL_CDR(RosPoseWithCovarianceStamped)
DDTOOL_CDR(RosDegeneracy)
DDTOOL_CDR(RosMapHeader)
DDTOOL_CDR(RosMapScan)
DDTOOL_CDR(RosMapDrive)
DDTOOL_CDR(RosMapGraph)
DDTOOL_CDR(RosMapTile)
DDTOOL_CDR(RosMapEnd)
DDTOOL_CDR(RosDiagnosticArray)
DDTOOL_CDR(RosClock)
DDTOOL_CDR(RosParticipantEntities<16>)
DDTOOL_CDR(RosParticipantEntities<24>)
#undef DDTOOL_CDR

}  // namespace ddtool
