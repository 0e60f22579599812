#include <cstring>
#include <stdexcept>

#include "logs/messages/ros_codec.hpp"

namespace ddtool {
namespace {

static_assert(std::endian::native == std::endian::little, "ROS 1 data is copied as it is");

struct EndOfData {};

class Ros1Reader {
public:
    explicit Ros1Reader(std::span<const std::byte> data) : rest_(data) {}
    void operator()(auto&... values) { (read(values), ...); }

private:
    void read(auto& message) { message.fields(message, *this); }
    template <typename Value>
    requires std::is_arithmetic_v<Value>
    void read(Value& value) { copy(&value, sizeof value); }
    void read(std::string& text) {
        text.resize(checked(count(), 1));
        copy(text.data(), text.size());
    }
    void read(RosTime& time) {
        const std::uint32_t seconds = count();
        time.ns = std::int64_t{1'000'000'000} * seconds + count();
    }
    void read(RosHeader& header) {
        count();  // the sequence number
        (*this)(header.stamp, header.frame_id);
    }
    template <std::size_t size>
    void read(std::array<double, size>& values) {
        copy(values.data(), sizeof values);
    }
    template <typename Value>
    void read(std::vector<Value>& values) {
        const std::uint32_t size = count();
        if constexpr (std::is_arithmetic_v<Value>) {
            values.resize(checked(size, sizeof(Value)));
            copy(values.data(), values.size() * sizeof(Value));
        } else {
            for (std::uint32_t i = 0; i < size; ++i) {
                read(values.emplace_back());
            }
        }
    }

    std::uint32_t count() {
        std::uint32_t value = 0;
        read(value);
        return value;
    }
    [[nodiscard]] std::size_t checked(std::size_t values, std::size_t bytes_each) const {
        return values <= rest_.size() / bytes_each ? values : throw EndOfData{};
    }
    void copy(void* target, std::size_t bytes) {
        if (checked(bytes, 1) > 0) {
            std::memcpy(target, rest_.data(), bytes);
            rest_ = rest_.subspan(bytes);
        }
    }

    std::span<const std::byte> rest_;
};

}  // namespace

template <typename Message>
std::optional<Message> decode_ros1(std::span<const std::byte> data) {
    try {
        Message message;
        Ros1Reader reader(data);
        reader(message);
        return message;
    } catch (const EndOfData&) {
        return std::nullopt;
    }
}

template std::optional<RosTFMessage> decode_ros1(std::span<const std::byte>);
template std::optional<RosLaserScan> decode_ros1(std::span<const std::byte>);
template std::optional<RosImu> decode_ros1(std::span<const std::byte>);
template std::optional<RosMultiEchoLaserScan> decode_ros1(std::span<const std::byte>);
template std::optional<RosPointCloud2> decode_ros1(std::span<const std::byte>);
template std::optional<RosOdometry> decode_ros1(std::span<const std::byte>);
template std::optional<RosPoseStamped> decode_ros1(std::span<const std::byte>);
template std::optional<RosTwistStamped> decode_ros1(std::span<const std::byte>);

}  // namespace ddtool
