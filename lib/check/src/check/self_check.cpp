#include "check/self_check.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "check/openness.hpp"

namespace ddtool::check {
namespace {

using Complex = std::complex<double>;

Complex mean_of(const std::vector<Complex>& places) {
    Complex sum;
    for (const Complex& place : places) {
        sum += place;
    }
    return sum / static_cast<double>(places.size());
}

std::vector<Complex> places_of(const std::vector<Pose2>& poses) {
    std::vector<Complex> places;
    for (const Pose2& pose : poses) {
        places.emplace_back(pose.x_m, pose.y_m);
    }
    return places;
}

/// Root of the mean squared distance between the two paths, after `moved` was shifted, turned and scaled to fit. With
/// positions as complex numbers, turn and scale are one factor, found by linear regression.
double distance_after_fit_m(const std::vector<Pose2>& fixed, const std::vector<Pose2>& moved) {
    if (fixed.empty()) {
        return 0.0;
    }
    const std::vector<Complex> to = places_of(fixed);
    const std::vector<Complex> from = places_of(moved);
    const Complex to_mean = mean_of(to);
    const Complex from_mean = mean_of(from);
    Complex products;
    double squares = 0.0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        products += std::conj(from[i] - from_mean) * (to[i] - to_mean);
        squares += std::norm(from[i] - from_mean);
    }
    const Complex factor = squares > 0.0 ? products / squares : Complex(1.0);
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        sum_m2 += std::norm(to[i] - to_mean - factor * (from[i] - from_mean));
    }
    return std::sqrt(sum_m2 / static_cast<double>(to.size()));
}

}  // namespace

void SelfCheck::add(const SensorFrame& frame, const std::optional<Update>& update) {
    kept_.offer(frame, update.has_value());
    steps_.add(frame);
    ++all_scans_;
    blind_scans_ +=
        std::ranges::none_of(frame.scan.ranges_m, [](float range_m) { return std::isfinite(range_m); }) ? 1 : 0;
    if (update) {
        motion_.add(*update, openness_of(Sight(frame), inverse(update->matched.odometry_motion)));
    }
}

Evidence SelfCheck::evidence(const Trajectory& path) const {
    // The scan whose update ended the run, because its map could not grow, has no pose.
    std::vector<KeptScan> scans = kept_.scans();
    std::erase_if(scans, [&](const KeptScan& scan) { return scan.index >= path.size(); });
    std::vector<Pose2> poses;
    std::vector<Pose2> by_odometry;
    for (const KeptScan& scan : scans) {
        poses.push_back(path[scan.index].pose);
        by_odometry.push_back(scan.odom_from_robot);
    }
    return {.scans = scans.size(),
            .all_scans = all_scans_,
            .blind_scans = blind_scans_,
            .neighbours = neighbours(scans, poses),
            .revisits = revisits(scans, poses),
            .odometry_revisits = revisits(scans, by_odometry),
            .from_odometry_m = distance_after_fit_m(poses, by_odometry),
            .motion = motion_.evidence(),
            .steps = steps_.evidence()};
}

}  // namespace ddtool::check
