#include "graph/packed_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool::graph {
namespace {

constexpr double most_steps = 32767.0;
constexpr double most_along = 255.0;
constexpr std::int32_t most_gap = 255;

double farthest_m(const ScanPoints& points) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        farthest = std::max({farthest, std::abs(static_cast<double>(points.x_m[i])), std::abs(double{points.y_m[i]})});
    }
    return farthest;
}

std::int16_t steps_of(double value, double step) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value / step, -most_steps, most_steps)));
}

/// No lidar sees farther; the settings allow no longer range (filter.points.usable_range_m).
constexpr double farthest_sight_m = 1000.0;

void expect_in_sight(const Point2& lidar_m) {
    if (!(std::abs(lidar_m.x_m) <= farthest_sight_m && std::abs(lidar_m.y_m) <= farthest_sight_m)) {
        throw Error("a scan of a lidar at (" + std::to_string(lidar_m.x_m) + " m, " + std::to_string(lidar_m.y_m) +
                    " m) on the robot; expected at most " + std::to_string(farthest_sight_m) + " m");
    }
}

}  // namespace

PackedScan::PackedScan(const ScanPoints& points) : origin_m_(points.origin_m), joined_(points.joined) {
    const double farthest = farthest_m(points);
    step_m_ = farthest > 0.0 ? farthest / most_steps : 1.0;
    points_.reserve(points.size());
    std::int32_t before = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double direction = std::atan2(double{points.normal_y[i]}, double{points.normal_x[i]});
        const double along = std::clamp(double{points.along_weight[i]}, 0.0, 1.0);
        points_.push_back({.x = steps_of(double{points.x_m[i]}, step_m_),
                           .y = steps_of(double{points.y_m[i]}, step_m_),
                           .normal = steps_of(direction, std::numbers::pi / most_steps),
                           .along = static_cast<std::uint8_t>(std::lround(most_along * along)),
                           .order_gap = static_cast<std::uint8_t>(std::clamp(points.order[i] - before, 0, most_gap))});
        before = points.order[i];
    }
}

ScanPoints PackedScan::unpacked() const {
    ScanPoints points;
    points.origin_m = origin_m_;
    points.joined = joined_;
    std::int32_t order = 0;
    for (const Point& point : points_) {
        const double direction = point.normal * std::numbers::pi / most_steps;
        order += point.order_gap;
        points.x_m.push_back(static_cast<float>(point.x * step_m_));
        points.y_m.push_back(static_cast<float>(point.y * step_m_));
        points.normal_x.push_back(static_cast<float>(std::cos(direction)));
        points.normal_y.push_back(static_cast<float>(std::sin(direction)));
        points.along_weight.push_back(static_cast<float>(point.along / most_along));
        points.order.push_back(order);
    }
    return points;
}

PackedScan::Columns PackedScan::columns() const {
    Columns columns{.origin_m = origin_m_,
                    .step_m = step_m_,
                    .x = {},
                    .y = {},
                    .normal = {},
                    .along = {},
                    .order_gap = {},
                    .joined = joined_};
    for (const Point& point : points_) {
        columns.x.push_back(point.x);
        columns.y.push_back(point.y);
        columns.normal.push_back(point.normal);
        columns.along.push_back(point.along);
        columns.order_gap.push_back(point.order_gap);
    }
    return columns;
}

PackedScan PackedScan::from(const Columns& columns) {
    const std::size_t size = columns.x.size();
    if (columns.y.size() != size || columns.normal.size() != size || columns.along.size() != size ||
        columns.order_gap.size() != size) {
        throw Error("a scan whose arrays differ in length; expected " + std::to_string(size) + " points in each");
    }
    expect_in_sight(columns.origin_m);
    if (!(columns.step_m > 0.0 && columns.step_m * most_steps <= farthest_sight_m)) {
        throw Error("a scan with the unit " + std::to_string(columns.step_m) + " m; expected more than 0 and at most " +
                    std::to_string(farthest_sight_m / most_steps));
    }
    std::size_t begin = 0;
    for (const ScanPoints::Joined& joined : columns.joined) {
        expect_in_sight(joined.origin_m);
        if (joined.begin < begin || joined.begin > size) {
            throw Error("a scan whose further lidars do not begin one after the other within its " +
                        std::to_string(size) + " points");
        }
        begin = joined.begin;
    }
    PackedScan scan;
    scan.origin_m_ = columns.origin_m;
    scan.step_m_ = columns.step_m;
    scan.joined_ = columns.joined;
    for (std::size_t i = 0; i < size; ++i) {
        scan.points_.push_back({.x = columns.x[i],
                                .y = columns.y[i],
                                .normal = columns.normal[i],
                                .along = columns.along[i],
                                .order_gap = columns.order_gap[i]});
    }
    return scan;
}

std::size_t PackedScan::bytes() const {
    return sizeof(*this) + points_.size() * sizeof(Point) + joined_.size() * sizeof(ScanPoints::Joined);
}

}  // namespace ddtool::graph
