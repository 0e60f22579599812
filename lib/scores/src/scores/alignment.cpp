#include "scores/alignment.hpp"

#include <cmath>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

/// The least-squares rotation of the centred positions, and then the translation that makes the centroids coincide
/// (Umeyama 1991, in the plane and without scale).
Pose2 umeyama_se2(std::span<const PosePair> pairs) {
    Point2 estimate_mean;
    Point2 reference_mean;
    const auto count = static_cast<double>(pairs.size());
    for (const PosePair& pair : pairs) {
        estimate_mean.x_m += pair.estimate.x_m / count;
        estimate_mean.y_m += pair.estimate.y_m / count;
        reference_mean.x_m += pair.reference.x_m / count;
        reference_mean.y_m += pair.reference.y_m / count;
    }
    double cosine_part = 0.0;
    double sine_part = 0.0;
    for (const PosePair& pair : pairs) {
        const double ex = pair.estimate.x_m - estimate_mean.x_m;
        const double ey = pair.estimate.y_m - estimate_mean.y_m;
        const double rx = pair.reference.x_m - reference_mean.x_m;
        const double ry = pair.reference.y_m - reference_mean.y_m;
        cosine_part += ex * rx + ey * ry;
        sine_part += ex * ry - ey * rx;
    }
    const double theta_rad = std::atan2(sine_part, cosine_part);
    const Point2 turned_mean = Pose2{0.0, 0.0, theta_rad} * estimate_mean;
    return {reference_mean.x_m - turned_mean.x_m, reference_mean.y_m - turned_mean.y_m, theta_rad};
}

}  // namespace

Alignment parse_alignment(std::string_view name) {
    if (name == "none") {
        return Alignment::none;
    }
    if (name == "first") {
        return Alignment::first;
    }
    if (name == "se2") {
        return Alignment::se2;
    }
    throw UsageError("alignment '" + std::string(name) + "': expected none, first or se2");
}

Pose2 reference_from_estimate(std::span<const PosePair> pairs, Alignment alignment) {
    switch (alignment) {
        case Alignment::first:
            return pairs.front().reference * inverse(pairs.front().estimate);
        case Alignment::se2:
            return umeyama_se2(pairs);
        case Alignment::none:
            break;
    }
    return {};
}

}  // namespace ddtool
