#pragma once

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// In a map that stays, scans that are taken near each other err alike, since they see the same places of the map with
/// the errors that it has there. A scan is independent of one that was taken this far away.
inline constexpr double independent_scan_m = 0.4;
/// The way of a motion for what scans tell; a turn shows something else, too: so much as this way for each radian.
inline constexpr double metres_per_radian = 0.3;
double way_for_scans_m(const Pose2& motion);

/// How far the end points of a log's scans usually lie from the surfaces of the map: the lidar's noise and what the map
/// adds to it. Learnt slowly and from many scans, so that the misfit of the present one, which may come
/// from a wrong match, hardly counts.
class ScanNoise {
public:
    /// squared_m2: the mean over the beams of a scan of the squared distance to the map
    void learn(double squared_m2);

    /// The factor on the exponent of the likelihood that makes equal evidence weigh alike for every lidar: 1 up to
    /// `full_weight_sd_m`, and beyond it (full_weight_sd_m / sd)^2, as in the likelihood of a normal distribution.
    /// 1 before the first scan, and if `full_weight_sd_m` is 0.
    [[nodiscard]] double weight(double full_weight_sd_m) const;
    /// The factor on the information of a match that was worked out for independent beams of the standard deviation
    /// `assumed_sd_m`, so that it becomes that of beams that err as they do: independent_share times (assumed_sd_m /
    /// sd)^2. Beams that hit one surface share the error of the map there. The share, and the least deviation that a
    /// beam counts with, are those with which the matcher's bench finds the matches along a corridor about as sure as
    /// they are right, for noise from 5 to 30 mm. 1 as long as too few scans were seen.
    [[nodiscard]] double information_factor(double assumed_sd_m) const;

    static constexpr double independent_share = 0.5;
    static constexpr double least_sd_m = 0.011;

private:
    double scans_ = 0.0;
    double mean_square_m2_ = 0.0;
};

}  // namespace ddtool
