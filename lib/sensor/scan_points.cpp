#include "sensor/scan_points.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// Second moments of the neighbours of a point, relative to it.
struct Moments {
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

    void add(double dx, double dy) {
        count += 1.0;
        x += dx;
        y += dy;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
};

constexpr std::size_t neighbours_each_side = 12;
constexpr double points_of_a_line = 4.0;

/// Adds neighbours from `point` in steps of `step` while they are of adjacent beams and within the radius.
void add_side(const ScanPoints& points, std::size_t point, int step, double radius_m, Moments& moments) {
    std::size_t last = point;
    for (std::size_t taken = 0; taken < neighbours_each_side; ++taken) {
        const std::size_t next = last + static_cast<std::size_t>(step);  // wraps below zero to a huge index
        if (next >= points.size() || std::abs(points.beam[next] - points.beam[last]) > 2) {
            return;
        }
        const double dx = static_cast<double>(points.x_m[next]) - static_cast<double>(points.x_m[point]);
        const double dy = static_cast<double>(points.y_m[next]) - static_cast<double>(points.y_m[point]);
        if (dx * dx + dy * dy > radius_m * radius_m) {
            return;
        }
        moments.add(dx, dy);
        last = next;
    }
}

void set_normal(ScanPoints& points, std::size_t point, const ScanPointsSettings& settings) {
    Moments m;
    m.add(0.0, 0.0);
    add_side(points, point, 1, settings.normal_radius_m, m);
    add_side(points, point, -1, settings.normal_radius_m, m);
    if (m.count < points_of_a_line) {
        return;
    }
    const double xx = m.xx / m.count - m.x * m.x / (m.count * m.count);
    const double xy = m.xy / m.count - m.x * m.y / (m.count * m.count);
    const double yy = m.yy / m.count - m.y * m.y / (m.count * m.count);
    const double root = std::hypot((xx - yy) / 2.0, xy);
    const double largest = (xx + yy) / 2.0 + root;
    const double smallest = (xx + yy) / 2.0 - root;
    const double line_angle_rad = std::atan2(2.0 * xy, xx - yy) / 2.0;
    points.normal_x[point] = static_cast<float>(-std::sin(line_angle_rad));
    points.normal_y[point] = static_cast<float>(std::cos(line_angle_rad));
    const double flatness = std::sqrt(std::max(smallest, 0.0) / std::max(largest, 1e-12));
    points.along_weight[point] = static_cast<float>(std::clamp(flatness, settings.min_along_weight, 1.0));
}

}  // namespace

ScanPoints scan_points(const SensorFrame& frame, const ScanPointsSettings& settings) {
    const LaserScan& scan = frame.scan;
    ScanPoints points;
    points.origin_m = {frame.robot_from_laser.x_m, frame.robot_from_laser.y_m};
    const std::size_t beams = scan.ranges_m.size();
    for (std::size_t i = 0; i < beams; ++i) {
        const double range_m = static_cast<double>(scan.ranges_m[i]);
        if (!(range_m <= settings.usable_range_m)) {
            continue;
        }
        const double angle = scan.angle_rad(i);
        const Point2 end = frame.robot_from_laser * Point2{range_m * std::cos(angle), range_m * std::sin(angle)};
        points.x_m.push_back(static_cast<float>(end.x_m));
        points.y_m.push_back(static_cast<float>(end.y_m));
        points.beam.push_back(static_cast<std::int32_t>(i));
    }
    points.normal_x.assign(points.size(), 1.0F);
    points.normal_y.assign(points.size(), 0.0F);
    points.along_weight.assign(points.size(), 1.0F);
    for (std::size_t point = 0; point < points.size(); ++point) {
        set_normal(points, point, settings);
    }
    return points;
}

}  // namespace ddtool
