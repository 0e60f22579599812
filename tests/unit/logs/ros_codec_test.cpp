#include "logs/messages/ros_codec.hpp"

#include <gtest/gtest.h>

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
    template <std::size_t size>
    void fill(std::array<double, size>& values) {
        for (double& value : values) {
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
                                RosParticleSnapshot, RosTwistStamped, RosTwistWithCovarianceStamped>;
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
