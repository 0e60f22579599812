#include "ddtool/network/linear_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "network/response.hpp"
#include "swarm/rules.hpp"

namespace ddtool {
namespace {

bool is_finite(double x, double y) { return std::isfinite(x) && std::isfinite(y); }

struct Extremes {
    double min_m = std::numeric_limits<double>::infinity();
    double max_m = -std::numeric_limits<double>::infinity();

    void include(double value_m) {
        min_m = std::min(min_m, value_m);
        max_m = std::max(max_m, value_m);
    }
};

struct Mapping {
    AxisMapping x;
    AxisMapping y;
};

Mapping centred_mapping(std::span<const Point2> points, double canvas_m, std::size_t size_px) {
    Extremes x;
    Extremes y;
    for (const Point2& point : points) {
        x.include(point.x_m);
        y.include(point.y_m);
    }
    return {{x.min_m, x.max_m, canvas_m, size_px}, {y.min_m, y.max_m, canvas_m, size_px}};
}

Mapping raw_mapping(std::size_t size_px) {
    const AxisMapping metre_a_pixel(0.0, 0.0, static_cast<double>(size_px), size_px);
    return {metre_a_pixel, metre_a_pixel};
}

}  // namespace

AxisMapping::AxisMapping(double min_m, double max_m, double canvas_m, std::size_t size_px)
    : min_m_(min_m), margin_m_((canvas_m - (max_m - min_m)) / 2.0), canvas_m_(canvas_m), size_px_(size_px) {}

std::optional<std::size_t> AxisMapping::pixel(double coordinate_m) const {
    // The distance from the lower extreme is computed first: it is the same number for two swarms that differ by a
    // shift only, so their images are equal.
    const double from_edge_m = (coordinate_m - min_m_) + margin_m_;
    if (!(from_edge_m >= 0.0 && from_edge_m <= canvas_m_)) {
        return std::nullopt;
    }
    const double index = from_edge_m * static_cast<double>(size_px_) / canvas_m_;
    return std::min(static_cast<std::size_t>(index), size_px_ - 1);
}

void coordinates(std::span<const SnapshotParticle> particles, const ImageSettings& settings,
                 std::vector<Point2>& points) {
    if (settings.swarm == Swarm::response) {
        response(particles, settings.step_canvas_min_m / settings.step_canvas_spreads, points);
        return;
    }
    points.clear();
    for (const SnapshotParticle& particle : particles) {
        const Pose2& place = settings.swarm == Swarm::step ? particle.matched_motion : particle.pose;
        if (is_finite(place.x_m, place.y_m)) {
            points.push_back({place.x_m, place.y_m});
        }
    }
}

double canvas_side_m(std::span<const SnapshotParticle> particles, const ImageSettings& settings) {
    if (settings.swarm == Swarm::absolute) {
        return settings.canvas_m;
    }
    if (settings.swarm == Swarm::response) {
        return settings.step_canvas_spreads;
    }
    return std::max(settings.step_canvas_min_m,
                    settings.step_canvas_spreads * spread_m(particles, &SnapshotParticle::predicted_motion));
}

void map_to_pixels(std::span<const Point2> points, double canvas_m, const ImageSettings& settings,
                   std::vector<ImagePixel>& places) {
    const Mapping mapping =
        settings.linear_mapping ? centred_mapping(points, canvas_m, settings.size_px) : raw_mapping(settings.size_px);
    places.clear();
    for (const Point2& point : points) {
        const std::optional<std::size_t> column = mapping.x.pixel(point.x_m);
        const std::optional<std::size_t> up = mapping.y.pixel(point.y_m);
        if (column && up) {
            places.push_back({settings.size_px - 1 - *up, *column});
        }
    }
}

}  // namespace ddtool
