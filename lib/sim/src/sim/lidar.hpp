#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"
#include "sim/ray_caster.hpp"

namespace ddtool::sim {

struct LidarSettings {
    int beams = 1680;
    double field_of_view_rad = 2.0 * std::numbers::pi;  ///< centred on the laser's x axis; 2 pi is a full turn
    double rate_hz = 12.0;
    double range_min_m = 0.1;
    double range_max_m = 30.0;
    double range_noise_m = 0.015;         ///< standard deviation at range 0
    double range_noise_per_m = 0.0;       ///< standard deviation added per metre of range
    double range_resolution_m = 0.001;    ///< ranges are rounded to multiples of it; 0 for no rounding
    double drop_out_probability = 0.002;  ///< probability that a beam is invalid
    double beam_divergence_rad = 0.003;   ///< full width; at an edge within it, the ranges of both sides mix
    bool motion_distortion = false;       ///< whether the motion of the robot during the scan is simulated
};

/// The standard deviation of a range, in metres.
inline double range_sd_m(const LidarSettings& settings, double range_m) {
    return settings.range_noise_m + settings.range_noise_per_m * range_m;
}

/// The settings of the preset `ls-m10p`, `rplidar-a1`, `hokuyo-utm-30lx` or `sick-lms`; docs/simulator.md has their
/// sources. Throws UsageError for any other name.
LidarSettings lidar_preset(const std::string& name);
std::vector<std::string> lidar_preset_names();

/// A scan with stamp, angles and limits, but without ranges. Without motion distortion all beams have the same time, so
/// that the time increment is 0.
LaserScan blank_scan(const LidarSettings& settings, std::int64_t stamp_ns);

/// For each beam the surface that it hits; nullopt if there is none within the maximum range.
using BeamHits = std::vector<std::optional<Hit>>;

/// The surface that each beam of `scan` hits.
/// \param world_from_laser one pose for each beam, or one pose for all
BeamHits cast_beams(const LaserScan& scan, const std::vector<Pose2>& world_from_laser, const RayCaster& caster);

/// The ranges in metres that a lidar would report for these hits, with mixed ranges at edges, noise, limits and
/// drop-outs.
/// \param world_from_laser as for cast_beams()
std::vector<float> measure_ranges(const LaserScan& scan, const std::vector<Pose2>& world_from_laser,
                                  const BeamHits& hits, const RayCaster& caster, const LidarSettings& settings,
                                  RandomStream random);

}  // namespace ddtool::sim
