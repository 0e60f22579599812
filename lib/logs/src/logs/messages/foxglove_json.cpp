#include "logs/messages/foxglove_json.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

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

std::optional<std::vector<PoseReading>> foxglove_json_poses(std::string_view type, std::span<const std::byte> data) {
    return read_json(data, [&](const json& message) { return poses(type, message); });
}

}  // namespace ddtool
