#include "graph/packed_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

std::size_t PackedScan::bytes() const {
    return sizeof(*this) + points_.size() * sizeof(Point) + joined_.size() * sizeof(ScanPoints::Joined);
}

}  // namespace ddtool::graph
