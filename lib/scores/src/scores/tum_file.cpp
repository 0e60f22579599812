#include "scores/tum_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <ostream>
#include <string_view>

#include "base/text.hpp"
#include "system/row_file.hpp"

namespace ddtool {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

std::optional<StampedPose> parse_pose(std::string_view line) {
    const std::optional<std::int64_t> stamp = parse_stamp(next_word(line));
    std::array<double, 7> values{};
    for (double& value : values) {
        const std::optional<double> number = parse_number(next_word(line));
        if (!number) {
            return std::nullopt;
        }
        value = *number;
    }
    const bool rotation_given = std::any_of(values.begin() + 3, values.end(), [](double each) { return each != 0.0; });
    if (!stamp || !rotation_given || !next_word(line).empty()) {
        return std::nullopt;
    }
    const auto [x, y, z, qx, qy, qz, qw] = values;
    // This formula also holds for a quaternion that is not of unit length.
    const double yaw = std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
    return StampedPose{*stamp, {x, y, yaw}};
}

}  // namespace

Trajectory read_tum(const std::filesystem::path& path) {
    Trajectory trajectory;
    for_each_row(path, "eight numbers 'stamp x y z qx qy qz qw' with a rotation (TUM)", [&](std::string_view line) {
        const std::optional<StampedPose> pose = parse_pose(line);
        if (pose) {
            trajectory.push_back(*pose);
        }
        return pose.has_value();
    });
    return trajectory;
}

void write_tum(const std::filesystem::path& path, const Trajectory& trajectory) {
    TumStream file(path);
    for (const StampedPose& pose : trajectory) {
        file.add(pose);
    }
    file.close();
}

TumStream::TumStream(const std::filesystem::path& path) : file_(path) {
    file_.write([](std::ostream& out) { out << "# stamp_s x_m y_m z_m qx qy qz qw\n"; });
}

void TumStream::add(const StampedPose& stamped) {
    const Pose2& pose = stamped.pose;
    const std::int64_t magnitude = stamped.stamp_ns < 0 ? -stamped.stamp_ns : stamped.stamp_ns;
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), "%s%lld.%09lld %.6f %.6f 0 0 0 %.9f %.9f\n",
                  stamped.stamp_ns < 0 ? "-" : "", static_cast<long long>(magnitude / ns_per_s),
                  static_cast<long long>(magnitude % ns_per_s), pose.x_m, pose.y_m, std::sin(pose.theta_rad / 2.0),
                  std::cos(pose.theta_rad / 2.0));
    file_.write([&](std::ostream& out) { out << text.data(); });
}

}  // namespace ddtool
