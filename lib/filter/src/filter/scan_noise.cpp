#include "ddtool/filter/scan_noise.hpp"

#include <algorithm>
#include <cmath>

#include "base/squared.hpp"

namespace ddtool {
namespace {

/// Older scans are gradually forgotten, since one place may be rougher than another.
constexpr double remembered_scans = 300.0;
/// The first scans lie on the map as if they had no noise, since the map was made of hardly anything else.
constexpr double least_scans = 20.0;

}  // namespace

double way_for_scans_m(const Pose2& motion) {
    return std::hypot(motion.x_m, motion.y_m) + metres_per_radian * std::abs(motion.theta_rad);
}

void ScanNoise::learn(double squared_m2) {
    scans_ = std::min(scans_ + 1.0, remembered_scans);
    mean_square_m2_ += (squared_m2 - mean_square_m2_) / scans_;
}

double ScanNoise::weight(double full_weight_sd_m) const {
    const double full_m2 = squared(full_weight_sd_m);
    return full_m2 == 0.0 || mean_square_m2_ <= full_m2 ? 1.0 : full_m2 / mean_square_m2_;
}

double ScanNoise::information_factor(double assumed_sd_m) const {
    return scans_ < least_scans
               ? 1.0
               : independent_share * squared(assumed_sd_m) / std::max(mean_square_m2_, squared(least_sd_m));
}

}  // namespace ddtool
