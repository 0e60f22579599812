#include "sim/lidar.hpp"

#include <cmath>
#include <map>

#include "ddtool/base/error.hpp"
#include "ddtool/base/random.hpp"

namespace ddtool::sim {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// Two surfaces whose ranges differ by less than this do not give a mixed range.
constexpr double echo_separation_m = 0.05;

const std::map<std::string, LidarSettings>& lidar_presets() {
    static const std::map<std::string, LidarSettings> table{
        {"ls-m10p", {}},
        {"rplidar-a1",
         {.beams = 360,
          .rate_hz = 5.5,
          .range_min_m = 0.15,
          .range_max_m = 12.0,
          .range_noise_m = 0.002,
          .range_noise_per_m = 0.005,
          .drop_out_probability = 0.01,
          .beam_divergence_rad = 0.005}},
        {"hokuyo-utm-30lx",
         {.beams = 1081,
          .field_of_view_rad = 270.0 * degree,
          .rate_hz = 40.0,
          .range_min_m = 0.1,
          .range_max_m = 30.0,
          .range_noise_m = 0.01,
          .range_noise_per_m = 0.0007,
          .drop_out_probability = 0.001,
          .beam_divergence_rad = 0.004}},
        {"sick-lms",
         {.beams = 361,
          .field_of_view_rad = 180.0 * degree,
          .rate_hz = 37.5,
          .range_min_m = 0.05,
          .range_max_m = 80.0,
          .range_noise_m = 0.005,
          .range_noise_per_m = 0.0,
          .range_resolution_m = 0.01,
          .drop_out_probability = 0.0005,
          .beam_divergence_rad = 0.008}},
    };
    return table;
}

double angle_increment_rad(const LidarSettings& settings) {
    const bool full_turn = settings.field_of_view_rad >= 2.0 * std::numbers::pi - 1e-9;
    return settings.field_of_view_rad / (settings.beams - (full_turn ? 0 : 1));
}

const Pose2& pose_of(const std::vector<Pose2>& world_from_laser, std::size_t beam) {
    return world_from_laser[world_from_laser.size() == 1 ? 0 : beam];
}

std::optional<Hit> cast_beam(const LaserScan& scan, const Pose2& laser, std::size_t beam, double aside_rad,
                             const RayCaster& caster) {
    const double angle_rad = laser.theta_rad + scan.angle_rad(beam) + aside_rad;
    return caster.cast(ray_at({laser.x_m, laser.y_m}, angle_rad), scan.range_max_m);
}

bool same_surface(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    return a && b ? a->surface == b->surface : !a && !b;
}

/// Whether an edge may lie within the footprint of a beam. If it does, it lies between the beam and one of its
/// neighbours, and the two hit different surfaces.
bool is_at_edge(const BeamHits& hits, std::size_t beam) {
    return (beam > 0 && !same_surface(hits[beam], hits[beam - 1])) ||
           (beam + 1 < hits.size() && !same_surface(hits[beam], hits[beam + 1]));
}

/// The range of a beam whose footprint contains an edge: a single echo at a random place between the ranges of the two
/// sides. Nullopt if the sides do not differ enough, or one of them gives no echo.
std::optional<double> mixed_range(const std::optional<Hit>& one, const std::optional<Hit>& other,
                                  RandomStream& random) {
    if (!one || !other || std::abs(one->range_m - other->range_m) < echo_separation_m) {
        return std::nullopt;
    }
    return one->range_m + random.uniform() * (other->range_m - one->range_m);
}

/// What the lidar reports for an echo at range_m; nullopt means that there is no echo.
float reading(const std::optional<double>& range_m, const LidarSettings& settings, RandomStream& random) {
    const double noise = random.normal();
    if (random.uniform() < settings.drop_out_probability) {
        return LaserScan::invalid;
    }
    if (!range_m) {
        return LaserScan::no_return;
    }
    const double noisy_m = *range_m + noise * range_sd_m(settings, *range_m);
    const double step_m = settings.range_resolution_m;
    return static_cast<float>(step_m > 0.0 ? step_m * std::round(noisy_m / step_m) : noisy_m);
}

}  // namespace

LidarSettings lidar_preset(const std::string& name) {
    const auto found = lidar_presets().find(name);
    if (found == lidar_presets().end()) {
        throw UsageError("unknown lidar '" + name + "'; expected ls-m10p, rplidar-a1, hokuyo-utm-30lx or sick-lms");
    }
    return found->second;
}

std::vector<std::string> lidar_preset_names() { return {"ls-m10p", "rplidar-a1", "hokuyo-utm-30lx", "sick-lms"}; }

LaserScan blank_scan(const LidarSettings& settings, std::int64_t stamp_ns) {
    LaserScan scan;
    scan.stamp_ns = stamp_ns;
    scan.angle_min_rad = -settings.field_of_view_rad / 2.0;
    scan.angle_increment_rad = angle_increment_rad(settings);
    if (settings.motion_distortion) {
        scan.time_increment_s = scan.angle_increment_rad / (2.0 * std::numbers::pi * settings.rate_hz);
        scan.scan_time_s = 1.0 / settings.rate_hz;
    }
    scan.range_min_m = settings.range_min_m;
    scan.range_max_m = settings.range_max_m;
    scan.ranges_m.assign(static_cast<std::size_t>(settings.beams), LaserScan::no_return);
    return scan;
}

BeamHits cast_beams(const LaserScan& scan, const std::vector<Pose2>& world_from_laser, const RayCaster& caster) {
    BeamHits hits(scan.ranges_m.size());
    for (std::size_t beam = 0; beam < hits.size(); ++beam) {
        hits[beam] = cast_beam(scan, pose_of(world_from_laser, beam), beam, 0.0, caster);
    }
    return hits;
}

std::vector<float> measure_ranges(const LaserScan& scan, const std::vector<Pose2>& world_from_laser,
                                  const BeamHits& hits, const RayCaster& caster, const LidarSettings& settings,
                                  RandomStream random) {
    std::vector<float> ranges;
    ranges.reserve(hits.size());
    const double half_width_rad = settings.beam_divergence_rad / 2.0;
    for (std::size_t beam = 0; beam < hits.size(); ++beam) {
        std::optional<double> range_m;
        if (half_width_rad > 0.0 && is_at_edge(hits, beam)) {
            const Pose2& laser = pose_of(world_from_laser, beam);
            range_m = mixed_range(cast_beam(scan, laser, beam, -half_width_rad, caster),
                                  cast_beam(scan, laser, beam, half_width_rad, caster), random);
        }
        if (!range_m && hits[beam]) {
            range_m = hits[beam]->range_m;
        }
        ranges.push_back(reading(range_m, settings, random));
    }
    return ranges;
}

}  // namespace ddtool::sim
