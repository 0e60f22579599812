#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include "logs/messages/ros_codec.hpp"

namespace ddtool {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::int64_t ns_per_s = 1'000'000'000;

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
    template <std::size_t size>
    void write(const std::array<double, size>& values) {
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
        constexpr std::size_t encapsulation_bytes = 4;
        while ((cdr_.getSerializedDataLength() - encapsulation_bytes) % size != 0) {
            cdr_.serialize(std::uint8_t{0});
        }
    }

    FastBuffer buffer_;
    Cdr cdr_;
};

/// Reads the fields of a message. Throws fast-cdr's exceptions if the data end too early.
class CdrReader {
public:
    /// The cast is safe: fast-cdr has no buffer of const bytes, but does not write to this one.
    explicit CdrReader(std::span<const std::byte> data)
        : buffer_(const_cast<char*>(reinterpret_cast<const char*>(data.data())),  // NOLINT(*-const-cast)
                  data.size()),
          cdr_(buffer_, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) {
        cdr_.read_encapsulation();
    }
    void operator()(auto&... values) { (read(values), ...); }

private:
    void read(auto& message) { message.fields(message, *this); }
    void read(Scalar auto& value) { cdr_.deserialize(value); }
    void read(std::string& text) { cdr_.deserialize(text); }
    void read(RosTime& time) {
        std::int32_t seconds = 0;
        std::uint32_t nanoseconds = 0;
        cdr_.deserialize(seconds);
        cdr_.deserialize(nanoseconds);
        time.ns = seconds * ns_per_s + nanoseconds;
    }
    template <std::size_t size>
    void read(std::array<double, size>& values) {
        cdr_.deserializeArray(values.data(), values.size());
    }
    /// The count may be damaged and huge. Numbers are therefore read only if the remaining bytes suffice for them, and
    /// other elements are read one by one.
    template <typename Value>
    void read(std::vector<Value>& values) {
        std::uint32_t count = 0;
        cdr_.deserialize(count);
        if constexpr (Scalar<Value>) {
            if (count > remaining() / sizeof(Value)) {
                throw eprosima::fastcdr::exception::NotEnoughMemoryException("sequence beyond the end");
            }
            values.resize(count);
            cdr_.deserializeArray(values.data(), values.size());
        } else {
            for (std::uint32_t i = 0; i < count; ++i) {
                read(values.emplace_back());
            }
        }
    }
    std::size_t remaining() {
        return buffer_.getBufferSize() - static_cast<std::size_t>(cdr_.getCurrentPosition() - buffer_.getBuffer());
    }

    FastBuffer buffer_;
    Cdr cdr_;
};

}  // namespace

template <typename Message>
std::vector<std::byte> encode_cdr(const Message& message, std::endian endian) {
    CdrWriter writer(endian);
    writer(message);
    return writer.take();
}

template <typename Message>
std::optional<Message> decode_cdr(std::span<const std::byte> data) {
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
#undef DDTOOL_CDR

}  // namespace ddtool
