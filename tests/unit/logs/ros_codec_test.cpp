#include "logs/messages/ros_codec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "ddtool/base/random.hpp"
#include "ros1_writer.hpp"

namespace ddtool {
namespace {

/// Gives every field another value, so that exchanged fields and wrong alignment are noticed.
class Filler {
public:
    void operator()(auto&... values) { (fill(values), ...); }

private:
    void fill(auto& message) { message.fields(message, *this); }
    template <typename Value>
    requires std::is_arithmetic_v<Value>
    void fill(Value& value) { value = static_cast<Value>(random_.index(100)); }
    void fill(std::string& text) { text.assign(random_.index(9), 'x'); }
    void fill(RosTime& time) {
        time.ns = 1'700'000'000'000'000'000 + static_cast<std::int64_t>(random_.index(1 << 30));
    }
    template <typename Value, std::size_t size>
    void fill(std::array<Value, size>& values) {
        for (Value& value : values) {
            fill(value);
        }
    }
    template <typename Value>
    void fill(std::vector<Value>& values) {
        values.resize(1 + random_.index(5));
        for (Value& value : values) {
            fill(value);
        }
    }

    RandomStream random_{5};
};

template <typename Message>
Message filled() {
    Message message;
    Filler filler;
    filler(message);
    return message;
}

template <typename Message>
class RosCodec : public testing::Test {};

using Messages = testing::Types<RosTFMessage, RosLaserScan, RosMultiEchoLaserScan, RosPointCloud2, RosOdometry,
                                RosPoseStamped, RosPoseArray, RosPath, RosOccupancyGrid, RosFloat64MultiArray,
                                RosParticleSnapshot, RosTwistStamped, RosTwistWithCovarianceStamped, RosDiagnosticArray,
                                RosClock, RosParticipantEntities<16>, RosParticipantEntities<24>>;
TYPED_TEST_SUITE(RosCodec, Messages);

/// Messages have no operator==. Their ROS 1 encodings are compared instead, which contain all fields and no padding.
template <typename Message>
void expect_same_message(const std::optional<Message>& decoded, const Message& message) {
    ASSERT_TRUE(decoded);
    EXPECT_EQ(test::encode_ros1(*decoded), test::encode_ros1(message));
}

TYPED_TEST(RosCodec, CdrGoesThereAndBackInBothByteOrders) {
    const auto message = filled<TypeParam>();
    for (const std::endian endian : {std::endian::little, std::endian::big}) {
        const std::vector<std::byte> data = encode_cdr(message, endian);
        expect_same_message(decode_cdr<TypeParam>(data), message);
        EXPECT_EQ(data[1], endian == std::endian::little ? std::byte{1} : std::byte{0});
    }
}

/// Leaves freed memory behind that is filled with `value`, so that reading uninitialised memory gives different
/// results.
void litter(char value) {
    std::vector<std::string> blocks;
    for (std::size_t size = 16; size < 4096; size += 16) {
        blocks.emplace_back(size, value);
    }
}

TYPED_TEST(RosCodec, CdrDoesNotDependOnWhatTheMemoryHeld) {
    const auto message = filled<TypeParam>();
    litter('a');
    const std::vector<std::byte> data = encode_cdr(message);
    litter('b');
    EXPECT_EQ(encode_cdr(message), data);
}

TYPED_TEST(RosCodec, CdrCutOffAnywhereIsRefused) {
    for (const std::endian endian : {std::endian::little, std::endian::big}) {
        const std::vector<std::byte> data = encode_cdr(filled<TypeParam>(), endian);
        for (std::size_t length = 0; length < data.size(); ++length) {
            // The copy has exactly this size, so that the address sanitizer notices a read beyond its end.
            const std::vector<std::byte> cut(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(length));
            EXPECT_FALSE(decode_cdr<TypeParam>(cut)) << length;
        }
    }
}

TYPED_TEST(RosCodec, CdrOfAnyBytesNeverCrashes) {
    const std::vector<std::byte> data = encode_cdr(filled<TypeParam>());
    for (std::uint64_t round = 0; round < 2000; ++round) {
        RandomStream random{11, round};
        std::vector<std::byte> damaged = data;
        for (int flips = 0; flips < 4; ++flips) {
            damaged[random.index(damaged.size())] = static_cast<std::byte>(random());
        }
        if (const auto decoded = decode_cdr<TypeParam>(damaged)) {
            EXPECT_LE(test::encode_ros1(*decoded).size(), 2 * damaged.size());
        }
    }
}

/// Serialises a message as XCDR version 2 does with types that are final (DDS-XTYPES 1.3, 7.4.3).
class PlainCdr2Writer {
public:
    explicit PlainCdr2Writer(std::endian endian) : endian_(endian) {
        bytes_ = {std::byte{0}, std::byte{endian == std::endian::big ? std::uint8_t{6} : std::uint8_t{7}}, {}, {}};
    }
    void operator()(const auto&... values) { (write(values), ...); }
    [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    void write(const auto& message) { message.fields(message, *this); }
    template <typename Value>
    requires std::is_arithmetic_v<Value>
    void write(const Value& value) {
        while ((bytes_.size() - 4) % std::min<std::size_t>(sizeof value, 4) != 0) {
            bytes_.emplace_back();
        }
        auto bytes = std::bit_cast<std::array<std::byte, sizeof value>>(value);
        if (endian_ == std::endian::big) {
            std::ranges::reverse(bytes);
        }
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    void write(const std::string& text) {
        write(static_cast<std::uint32_t>(text.size() + 1));
        for (const char c : text + std::string(1, '\0')) {
            write(static_cast<std::uint8_t>(c));
        }
    }
    void write(const RosTime& time) {
        write(static_cast<std::int32_t>(time.ns / 1'000'000'000));
        write(static_cast<std::uint32_t>(time.ns % 1'000'000'000));
    }
    template <typename Value, std::size_t size>
    void write(const std::array<Value, size>& values) {
        std::ranges::for_each(values, [&](Value value) { write(value); });
    }
    template <typename Value>
    void write(const std::vector<Value>& values) {
        if constexpr (!std::is_arithmetic_v<Value>) {
            write(std::uint32_t{12345});  // the length, which need not be right to be skipped
        }
        write(static_cast<std::uint32_t>(values.size()));
        std::ranges::for_each(values, [&](const Value& value) { write(value); });
    }

    std::endian endian_;
    std::vector<std::byte> bytes_;
};

TYPED_TEST(RosCodec, PlainCdr2IsReadInBothByteOrders) {
    const auto message = filled<TypeParam>();
    for (const std::endian endian : {std::endian::little, std::endian::big}) {
        PlainCdr2Writer writer(endian);
        writer(message);
        expect_same_message(decode_cdr<TypeParam>(writer.bytes()), message);
    }
}

TYPED_TEST(RosCodec, OtherEncapsulationsAreNamed) {
    std::vector<std::byte> data = encode_cdr(filled<TypeParam>());
    EXPECT_EQ(unknown_cdr(data), "");
    for (const int id : {0x02, 0x03, 0x08, 0x09, 0x0A, 0x0B}) {
        data[1] = static_cast<std::byte>(id);
        EXPECT_NE(unknown_cdr(data), "");
        EXPECT_FALSE(decode_cdr<TypeParam>(data));
    }
}

template <typename Message>
class Ros1Codec : public testing::Test {};

using Ros1Messages = testing::Types<RosTFMessage, RosLaserScan, RosOdometry, RosPoseStamped, RosTwistStamped>;
TYPED_TEST_SUITE(Ros1Codec, Ros1Messages);

TYPED_TEST(Ros1Codec, GoesThereAndBackAndIsRefusedWhereItIsCut) {
    const auto message = filled<TypeParam>();
    const std::vector<std::byte> data = test::encode_ros1(message);
    expect_same_message(decode_ros1<TypeParam>(data), message);
    for (std::size_t length = 0; length < data.size(); ++length) {
        const std::vector<std::byte> cut(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_FALSE(decode_ros1<TypeParam>(cut)) << length;
    }
}

TEST(Cdr, KeepsTimesBefore1970) {
    RosPoseStamped message;
    message.header.stamp.ns = -1;
    EXPECT_EQ(decode_cdr<RosPoseStamped>(encode_cdr(message)).value().header.stamp.ns, -1);
}

TEST(Cdr, IsLaidOutAsTheSpecificationSays) {
    RosPoseStamped message;
    message.header = {{2'000'000'003}, "map"};
    message.pose.position.x = 1.0;
    const std::vector<std::byte> data = encode_cdr(message);
    // 4 bytes of encapsulation, 4 of sec, 4 of nanosec, 4 of length and "map\0"; then the doubles, aligned to 8 bytes
    // counted from the end of the encapsulation.
    ASSERT_EQ(data.size(), 4U + 16U + 56U);
    const auto word = [&](std::size_t at) { return std::to_integer<int>(data[at]); };
    EXPECT_EQ(word(4), 2);
    EXPECT_EQ(word(8), 3);
    EXPECT_EQ(word(12), 4);
    EXPECT_EQ(word(16), 'm');
    double x = 0.0;
    std::memcpy(&x, &data[20], sizeof x);
    EXPECT_EQ(x, 1.0);
}

}  // namespace
}  // namespace ddtool
