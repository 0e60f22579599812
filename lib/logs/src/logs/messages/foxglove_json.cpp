#include "logs/messages/foxglove_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "logs/messages/foxglove_cloud.hpp"
#include "logs/messages/foxglove_scan.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

using nlohmann::json;

/// Reads a whole number, which JSON may also write as 1e9. For a number that does not fit, returns the largest one.
std::int64_t whole(const json& number) {
    constexpr double limit = 9e15;
    const auto value = number.get<double>();
    return std::abs(value) < limit ? static_cast<std::int64_t>(value) : std::numeric_limits<std::int64_t>::max();
}

/// A number of bytes. For one that does not fit, returns the largest one.
std::uint32_t byte_count(const json& number) {
    constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(whole(number), 0, most));
}

std::int64_t stamp(const json& message) {
    const json& time = message.at("timestamp");
    return foxglove_stamp_ns(whole(time.at("sec")), whole(time.at("nsec")));
}

RosVector3 vector(const json& v) { return {v.at("x"), v.at("y"), v.at("z")}; }

RosQuaternion quaternion(const json& q) { return {q.at("x"), q.at("y"), q.at("z"), q.at("w")}; }

Eigen::Isometry3d json_isometry(const json& pose) {
    return to_isometry({vector(pose.at("position")), quaternion(pose.at("orientation"))});
}

PoseReading transform(const json& message) {
    return {stamp(message), message.at("parent_frame_id"), message.at("child_frame_id"),
            to_isometry({vector(message.at("translation")), quaternion(message.at("rotation"))})};
}

std::vector<PoseReading> poses(std::string_view type, const json& message) {
    if (type == "foxglove.PoseInFrame") {
        return {{stamp(message), message.at("frame_id"), "", json_isometry(message.at("pose"))}};
    }
    if (type == "foxglove.FrameTransform") {
        return {transform(message)};
    }
    std::vector<PoseReading> readings;
    for (const json& one : message.at("transforms")) {
        readings.push_back(transform(one));
    }
    return readings;
}

ScanReading scan(const json& message) {
    ScanReading reading;
    reading.frame_id = message.at("frame_id");
    if (message.contains("pose")) {
        reading.frame_from_scan = json_isometry(message.at("pose"));
    }
    reading.scan.stamp_ns = stamp(message);
    for (const json& range : message.at("ranges")) {
        reading.scan.ranges_m.push_back(range.is_null() ? LaserScan::invalid : range.get<float>());
    }
    set_foxglove_angles(reading.scan, message.at("start_angle"), message.at("end_angle"));
    return reading;
}

/// The bytes that base64 (RFC 4648, section 4) stands for, up to the first character that is no digit of it.
std::vector<std::byte> bytes_of_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    std::size_t count = 0;
    for (const char character : text) {
        const std::size_t digit = digits.find(character);
        if (digit == std::string_view::npos) {
            break;
        }
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count));
        }
    }
    return bytes;
}

CloudReading json_cloud(const json& message) {
    CloudReading reading{.stamp_ns = stamp(message), .frame_id = message.at("frame_id")};
    if (message.contains("pose")) {
        reading.frame_from_cloud = json_isometry(message.at("pose"));
    }
    std::vector<PackedField> fields;
    for (const json& field : message.at("fields")) {
        fields.push_back({field.at("name"), byte_count(field.at("offset")), foxglove_number(whole(field.at("type")))});
    }
    const std::vector<std::byte> bytes = bytes_of_base64(message.at("data").get_ref<const std::string&>());
    unpack_foxglove(reading, bytes, std::move(fields), byte_count(message.at("point_stride")));
    return reading;
}

/// Returns what `read` returns for the parsed document. Nullopt if the bytes are not JSON, or if a member is missing or
/// has another type.
template <typename Read>
auto read_json(std::span<const std::byte> data, Read read) -> std::optional<decltype(read(json()))> {
    const auto* text = reinterpret_cast<const char*>(data.data());
    try {
        return read(json::parse(text, text + data.size()));
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<ScanReading> foxglove_json_scan(std::span<const std::byte> data) {
    return read_json(data, [](const json& message) { return scan(message); });
}

std::optional<CloudReading> foxglove_json_cloud(std::span<const std::byte> data) {
    return read_json(data, [](const json& message) { return json_cloud(message); });
}

std::optional<std::vector<PoseReading>> foxglove_json_poses(std::string_view type, std::span<const std::byte> data) {
    return read_json(data, [&](const json& message) { return poses(type, message); });
}

}  // namespace ddtool
