#include "check/sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ddtool::check {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

/// So many points of a scan are compared with another scan; more tell the same.
constexpr std::size_t compared_points = 120;

/// Nearer end points may lie on the robot itself, which is elsewhere at another scan.
constexpr float robot_radius_m = 0.6F;

/// A point counts as the same surface within this distance. It covers the noise of common lidars three times over
/// (range noise of 30 mm, and 1 % of the range for cheap ones), and what a small error of the heading moves far points.
double tolerance_at(double range_m) { return 0.12 + 0.02 * range_m; }

Agreement one_way(const Sight& by, const Sight& of, const Pose2& by_laser_from_of_laser) {
    Agreement result;
    const std::size_t stride = std::max<std::size_t>(1, of.beams() / compared_points);
    for (std::size_t beam = 0; beam < of.beams(); beam += stride) {
        const float range_m = of.range_m(beam);
        if (!std::isfinite(range_m) || range_m < robot_radius_m) {
            continue;
        }
        const Point2 point = by_laser_from_of_laser * of.end(beam);
        const double farther_m = std::max(static_cast<double>(range_m), std::hypot(point.x_m, point.y_m));
        const Sight::Word word = by.word_on(point, tolerance_at(farther_m));
        result.same += word == Sight::Word::same ? 1 : 0;
        result.through += word == Sight::Word::through ? 1 : 0;
    }
    return result;
}

double distance_to_segment_m(Point2 point, Point2 from, Point2 to) {
    const double dx = to.x_m - from.x_m;
    const double dy = to.y_m - from.y_m;
    const double length2 = dx * dx + dy * dy;
    const double along =
        length2 > 0.0 ? std::clamp(((point.x_m - from.x_m) * dx + (point.y_m - from.y_m) * dy) / length2, 0.0, 1.0)
                      : 0.0;
    return std::hypot(point.x_m - from.x_m - along * dx, point.y_m - from.y_m - along * dy);
}

}  // namespace

Sight::Sight(const SensorFrame& frame) : robot_from_laser_(frame.robot_from_laser) {
    const LaserScan& scan = frame.scan;
    const std::size_t count = scan.ranges_m.size();
    const std::size_t stride = (count + most_beams - 1) / most_beams;
    for (std::size_t beam = 0; stride > 0 && beam < count; beam += stride) {
        ranges_m_.push_back(scan.ranges_m[beam]);
    }
    increment_rad_ = scan.angle_increment_rad * static_cast<double>(stride);
    angle_min_rad_ = scan.angle_min_rad;
    if (increment_rad_ < 0.0) {
        angle_min_rad_ += increment_rad_ * static_cast<double>(ranges_m_.size() - 1);
        increment_rad_ = -increment_rad_;
        std::reverse(ranges_m_.begin(), ranges_m_.end());
    }
    full_turn_ = increment_rad_ * static_cast<double>(ranges_m_.size() + 1) > turn_rad;
}

Point2 Sight::end(std::size_t beam) const {
    const auto range_m = static_cast<double>(ranges_m_[beam]);
    return {range_m * std::cos(angle_rad(beam)), range_m * std::sin(angle_rad(beam))};
}

/// A surface is taken to go straight from each end point to the next. Where they belong to two things this finds a
/// surface in between that is none, which only makes fewer points count as seen through.
bool Sight::surface_near(Point2 point, std::size_t beam, double tolerance_m) const {
    if (!std::isfinite(ranges_m_[beam])) {
        return false;
    }
    const std::size_t next = beam + 1 < ranges_m_.size() ? beam + 1 : (full_turn_ ? 0 : beam);
    const Point2 from = end(beam);
    const Point2 to = std::isfinite(ranges_m_[next]) ? end(next) : from;
    return distance_to_segment_m(point, from, to) <= tolerance_m;
}

Sight::Word Sight::word_on(Point2 point, double tolerance_m) const {
    const double range_m = std::hypot(point.x_m, point.y_m);
    if (ranges_m_.size() < 2 || increment_rad_ <= 0.0 || range_m < 2.0 * tolerance_m) {
        return Word::nothing;
    }
    const auto count = static_cast<std::ptrdiff_t>(ranges_m_.size());
    const double turned = std::remainder(std::atan2(point.y_m, point.x_m) - angle_min_rad_, turn_rad);
    const auto centre =
        static_cast<std::ptrdiff_t>(std::lround((turned < 0.0 ? turned + turn_rad : turned) / increment_rad_));
    const auto wing =
        std::max<std::ptrdiff_t>(1, std::lround(std::asin(std::min(1.0, tolerance_m / range_m)) / increment_rad_));
    bool farther = true;
    std::ptrdiff_t echoes = 0;
    for (std::ptrdiff_t beam = centre - wing - 1; beam <= centre + wing; ++beam) {
        const std::ptrdiff_t at = full_turn_ ? (beam % count + count) % count : beam;
        if (at < 0 || at >= count) {
            farther = false;  // the surroundings of the point are not all in sight
            continue;
        }
        if (surface_near(point, static_cast<std::size_t>(at), tolerance_m)) {
            return Word::same;
        }
        if (beam >= centre - wing) {
            const auto echo_m = static_cast<double>(ranges_m_[static_cast<std::size_t>(at)]);
            farther &= !(echo_m <= range_m + tolerance_m);  // an echo that failed hinders nothing
            echoes += std::isfinite(echo_m) ? 1 : 0;
        }
    }
    return farther && 2 * echoes > 2 * wing + 1 ? Word::through : Word::nothing;
}

double Agreement::contradicted() const {
    return points() == 0 ? 0.0 : static_cast<double>(through) / static_cast<double>(points());
}

Agreement agreement(const Sight& by, const Sight& of, const Pose2& by_from_of) {
    const Pose2 by_laser_from_of_laser = inverse(by.robot_from_laser()) * by_from_of * of.robot_from_laser();
    const Agreement there = one_way(by, of, by_laser_from_of_laser);
    const Agreement back = one_way(of, by, inverse(by_laser_from_of_laser));
    return {there.same + back.same, there.through + back.through};
}

}  // namespace ddtool::check
