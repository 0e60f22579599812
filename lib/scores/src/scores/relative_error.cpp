#include "scores/relative_error.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

double step(const PosePair& previous, const PosePair& current, DeltaUnit unit) {
    return unit == DeltaUnit::metres ? distance_m(previous.estimate, current.estimate)
                                     : static_cast<double>(current.stamp_ns - previous.stamp_ns) * 1e-9;
}

std::vector<std::size_t> every_nth(std::size_t count, std::size_t n) {
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < count; node += n) {
        nodes.push_back(node);
    }
    return nodes;
}

/// The pairs at which the delta has been covered since the node before.
std::vector<std::size_t> nodes_along(std::span<const PosePair> pairs, const RpeDelta& delta) {
    std::vector<std::size_t> nodes;
    double covered = 0.0;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        covered += step(pairs[i - 1], pairs[i], delta.unit);
        if (covered >= delta.value) {
            nodes.push_back(i);
            covered = 0.0;
        }
    }
    return nodes;
}

std::vector<std::size_t> chain(std::span<const PosePair> pairs, const RpeDelta& delta) {
    if (!(delta.value > 0.0)) {
        throw UsageError("RPE delta: expected a number above 0");
    }
    if (delta.unit != DeltaUnit::frames) {
        return nodes_along(pairs, delta);
    }
    if (delta.value != std::floor(delta.value) || delta.value > 1e9) {
        throw UsageError("RPE delta: expected a whole number of frames");
    }
    return every_nth(pairs.size(), static_cast<std::size_t>(delta.value));
}

}  // namespace

DeltaUnit parse_delta_unit(std::string_view name) {
    if (name == "frames") {
        return DeltaUnit::frames;
    }
    if (name == "metres") {
        return DeltaUnit::metres;
    }
    if (name == "seconds") {
        return DeltaUnit::seconds;
    }
    throw UsageError("RPE delta unit '" + std::string(name) + "': expected frames, metres or seconds");
}

RpeResult relative_pose_error(std::span<const PosePair> pairs, const RpeDelta& delta) {
    const std::vector<std::size_t> nodes = chain(pairs, delta);
    std::vector<double> translation_m;
    std::vector<double> rotation_deg;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const PosePair& from = pairs[nodes[i - 1]];
        const PosePair& to = pairs[nodes[i]];
        const Pose2 error = between(between(from.reference, to.reference), between(from.estimate, to.estimate));
        translation_m.push_back(std::hypot(error.x_m, error.y_m));
        rotation_deg.push_back(std::abs(error.theta_rad) * 180.0 / std::numbers::pi);
    }
    return {error_statistics(translation_m), error_statistics(rotation_deg)};
}

}  // namespace ddtool
