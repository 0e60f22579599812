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
    double range_noise_per_m = 0.0;       ///< standard deviation that a metre of range adds
    double range_resolution_m = 0.001;    ///< ranges are whole multiples of it; 0 for none
    double drop_out_probability = 0.002;  ///< of a beam that says nothing
    double beam_divergence_rad = 0.003;   ///< full width: edges within it mix the ranges on both sides
    bool motion_distortion = false;       ///< whether the robot moves while the scan is taken
};

/// Standard deviation of a range.
inline double range_sd_m(const LidarSettings& settings, double range_m) {
    return settings.range_noise_m + settings.range_noise_per_m * range_m;
}

/// `ls-m10p`, `rplidar-a1`, `hokuyo-utm-30lx`, `sick-lms`; docs/simulator.md has their sources.
/// Throws UsageError for another name.
LidarSettings lidar_preset(const std::string& name);
std::vector<std::string> lidar_preset_names();

/// A scan without ranges yet: stamp, angles, limits. The time increment is 0 without motion distortion, since then all
/// beams are of one instant.
LaserScan blank_scan(const LidarSettings& settings, std::int64_t stamp_ns);

/// One beam's surface, or none within the range limit.
using BeamHits = std::vector<std::optional<Hit>>;

/// What each beam of `scan` meets. world_from_laser has one pose per beam, or one for all.
BeamHits cast_beams(const LaserScan& scan, const std::vector<Pose2>& world_from_laser, const RayCaster& caster);

/// The ranges a lidar would report of these hits: mixed pixels at edges, noise, limits, drop-outs.
std::vector<float> measure_ranges(const LaserScan& scan, const std::vector<Pose2>& world_from_laser,
                                  const BeamHits& hits, const RayCaster& caster, const LidarSettings& settings,
                                  RandomStream random);

}  // namespace ddtool::sim
