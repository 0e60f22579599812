#include "sim/simulation_json.hpp"

#include <cmath>
#include <initializer_list>

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "sim/pose2_json.hpp"

namespace ddtool::sim {

DDTOOL_JSON_STRUCT(LidarSettings, beams, field_of_view_rad, rate_hz, range_min_m, range_max_m, range_noise_m,
                   range_noise_per_m, range_resolution_m, drop_out_probability, beam_divergence_rad, motion_distortion)
DDTOOL_JSON_STRUCT(OdometrySettings, rate_hz, scale_error_sd, gyro_bias_sd_rad_per_s, distance_noise_m_per_sqrt_m,
                   heading_noise_rad_per_sqrt_m, heading_noise_rad_per_sqrt_rad, slips_per_m, slip_m, slip_rad)
DDTOOL_JSON_STRUCT(DriveSettings, speed_m_per_s, acceleration_m_per_s2, turn_rate_rad_per_s,
                   turn_acceleration_rad_per_s2, turn_in_place_above_rad, lookahead_m)

namespace {

/// A preset's name, and a null for every value that it sets.
Json preset_keys(const std::string& preset, const Json& values) {
    Json keys{{"preset", preset}};
    for (const auto& item : values.items()) {
        keys[item.key()] = nullptr;
    }
    return keys;
}

/// The preset's values with those that the configuration gives in their place; `name` is where both stand.
Json resolved(const std::string& name, const Json& preset, const Json& configured) {
    Json settings{{name, preset}};
    Json changes{{name, Json::object()}};
    for (const auto& [key, value] : configured.items()) {
        if (key != "preset" && !value.is_null()) {
            changes[name][key] = value;
        }
    }
    merge_settings(settings, changes, "simulation");
    return settings[name];
}

void expect(bool good, const std::string& key, const std::string& expected) {
    if (!good) {
        throw UsageError(key + ": expected " + expected);
    }
}

void expect_not_negative(const Json& values, const std::string& where) {
    for (const auto& [key, value] : values.items()) {
        std::string name = where;
        name.append(".").append(key);
        expect(!value.is_number() || value.get<double>() >= 0.0, name, "a number, 0 or more");
    }
}

LidarSettings lidar_from(const Json& json) {
    const Json values = resolved("lidar", lidar_preset(json.at("preset").get<std::string>()), json);
    const auto lidar = values.get<LidarSettings>();
    expect_not_negative(values, "lidar");
    expect(lidar.beams >= 2, "lidar.beams", "2 or more");
    expect(lidar.field_of_view_rad > 0.0 && lidar.field_of_view_rad <= 2.0 * std::numbers::pi + 1e-9,
           "lidar.field_of_view_rad", "more than 0 and at most 2 pi");
    expect(lidar.rate_hz > 0.0, "lidar.rate_hz", "a number above 0");
    expect(lidar.range_min_m < lidar.range_max_m, "lidar.range_max_m", "more than lidar.range_min_m");
    expect(lidar.range_noise_m > 0.0 || lidar.range_noise_per_m > 0.0, "lidar.range_noise_m",
           "a number above 0, since the Fisher information divides by it");
    expect(lidar.drop_out_probability <= 1.0, "lidar.drop_out_probability", "a number from 0 to 1");
    return lidar;
}

OdometrySettings odometry_from(const Json& json) {
    const Json values = resolved("odometry", odometry_preset(json.at("preset").get<std::string>()), json);
    const auto odometry = values.get<OdometrySettings>();
    expect_not_negative(values, "odometry");
    expect(odometry.rate_hz > 0.0, "odometry.rate_hz", "a number above 0");
    return odometry;
}

}  // namespace

Json default_simulation_json() {
    const SimulationSettings defaults;
    return {{"world", "s2"},
            {"seed", defaults.seed},
            {"start_ns", defaults.start_ns},
            {"robot_from_laser", defaults.robot_from_laser},
            {"lidar", preset_keys("ls-m10p", defaults.lidar)},
            {"odometry", preset_keys("typical", defaults.odometry)},
            {"drive", defaults.drive}};
}

Json common_simulation_json() {
    Json json = default_simulation_json();
    json.erase("world");
    json.erase("seed");
    return json;
}

SimulationSettings simulation_from_json(const Json& json) {
    return {.seed = json.at("seed").get<std::uint64_t>(),
            .start_ns = json.at("start_ns").get<std::int64_t>(),
            .robot_from_laser = json.at("robot_from_laser").get<Pose2>(),
            .lidar = lidar_from(json.at("lidar")),
            .odometry = odometry_from(json.at("odometry")),
            .drive = json.at("drive").get<DriveSettings>()};
}

}  // namespace ddtool::sim
