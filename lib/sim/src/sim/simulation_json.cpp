#include "sim/simulation_json.hpp"

#include <array>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {

namespace {

/// Stamps are 64-bit nanoseconds, which reach up to 9.2e18.
const Allowed start_ns = Allowed::whole(0.0, 4e18);

const Allowed more_lasers = Allowed::numbers(0, -1000.0, 1000.0);

/// The settings that common_simulation_json() has not.
constexpr std::array<const char*, 4> not_common{"world", "seed", "more_lasers", "imu"};

constexpr double turn_rad = 6.28318531;  // 2 pi, rounded up so that 2 pi itself is allowed

std::string below(const std::string& path, const std::string& key) {
    return path.empty() ? key : std::string(path).append(".").append(key);
}

const SettingTable<Pose2>& pose_rows() {
    static const SettingTable<Pose2> rows{
        {"x_m", &Pose2::x_m, Allowed::number(-1000.0, 1000.0), "m", "Place of the laser on the robot, forwards."},
        {"y_m", &Pose2::y_m, Allowed::number(-1000.0, 1000.0), "m", "Place of the laser on the robot, to the left."},
        {"theta_rad", &Pose2::theta_rad, Allowed::number(-turn_rad, turn_rad), "rad",
         "Direction of the laser on the robot, counterclockwise from straight ahead."},
    };
    return rows;
}

const SettingTable<LidarSettings>& lidar_rows() {
    using Lidar = LidarSettings;
    static const SettingTable<Lidar> rows{
        {"beams", &Lidar::beams, Allowed::whole(2, 100000), "", "Number of beams of a scan."},
        {"field_of_view_rad", &Lidar::field_of_view_rad, Allowed::number(1e-3, turn_rad), "rad",
         "Angle that a scan covers, centred on the laser's x axis; 2 pi is a full turn."},
        {"rate_hz", &Lidar::rate_hz, Allowed::number(1e-3, 1000.0), "Hz", "Number of scans per second."},
        {"range_min_m", &Lidar::range_min_m, Allowed::number(0.0, 10000.0), "m", "Shorter ranges are not reported."},
        {"range_max_m", &Lidar::range_max_m, Allowed::number(1e-3, 10000.0), "m", "Longer ranges are not reported."},
        {"range_noise_m", &Lidar::range_noise_m, Allowed::number(0.0, 100.0), "m",
         "Standard deviation of a range, at range 0."},
        {"range_noise_per_m", &Lidar::range_noise_per_m, Allowed::number(0.0, 10.0), "",
         "Standard deviation that each metre of range adds."},
        {"range_resolution_m", &Lidar::range_resolution_m, Allowed::number(0.0, 100.0), "m",
         "Ranges are whole multiples of it; 0 leaves them as they are."},
        {"drop_out_probability", &Lidar::drop_out_probability, Allowed::number(0.0, 1.0), "",
         "Probability that a beam reports nothing."},
        {"beam_divergence_rad", &Lidar::beam_divergence_rad, Allowed::number(0.0, 1.0), "rad",
         "Full width of a beam: an edge within it mixes the ranges on both sides."},
        {"motion_distortion", &Lidar::motion_distortion, Allowed::flag(), "",
         "Whether the robot moves while a scan is taken."},
    };
    return rows;
}

const SettingTable<OdometrySettings>& odometry_rows() {
    using Odometry = OdometrySettings;
    static const SettingTable<Odometry> rows{
        {"rate_hz", &Odometry::rate_hz, Allowed::number(1e-3, 10000.0), "Hz", "Number of odometry poses per second."},
        {"scale_error_sd", &Odometry::scale_error_sd, Allowed::number(0.0, 1.0), "",
         "Standard deviation over runs of the relative error of distances (the wheels' radius)."},
        {"turn_error", &Odometry::turn_error, Allowed::number(-0.9, 10.0), "",
         "Relative error of turns (the distance between the wheels), the same in all runs."},
        {"gyro_bias_sd_rad_per_s", &Odometry::gyro_bias_sd_rad_per_s, Allowed::number(0.0, 10.0), "rad/s",
         "Standard deviation over runs of the error of the turn rate."},
        {"distance_noise_m_per_sqrt_m", &Odometry::distance_noise_m_per_sqrt_m, Allowed::number(0.0, 10.0), "m/sqrt(m)",
         "Noise of the way that grows with the way."},
        {"heading_noise_rad_per_sqrt_m", &Odometry::heading_noise_rad_per_sqrt_m, Allowed::number(0.0, 10.0),
         "rad/sqrt(m)", "Noise of the heading that grows with the way."},
        {"heading_noise_rad_per_sqrt_rad", &Odometry::heading_noise_rad_per_sqrt_rad, Allowed::number(0.0, 10.0),
         "rad/sqrt(rad)", "Noise of the heading that grows with turning."},
        {"slips_per_m", &Odometry::slips_per_m, Allowed::number(0.0, 1000.0), "1/m",
         "Mean number of slips of the wheels on a metre of way.", "a Poisson process along the way"},
        {"slip_m", &Odometry::slip_m, Allowed::number(0.0, 100.0), "m",
         "Mean distance that the wheels turn too far in a slip.", "exponentially distributed"},
        {"slip_rad", &Odometry::slip_rad, Allowed::number(0.0, 10.0), "rad",
         "Standard deviation of the error of the heading in a slip."},
    };
    return rows;
}

const SettingTable<DriveSettings>& drive_rows() {
    using Drive = DriveSettings;
    static const SettingTable<Drive> rows{
        {"speed_m_per_s", &Drive::speed_m_per_s, Allowed::number(0.01, 100.0), "m/s", "The robot drives no faster."},
        {"acceleration_m_per_s2", &Drive::acceleration_m_per_s2, Allowed::number(0.01, 100.0), "m/s^2",
         "The robot speeds up and brakes no harder."},
        {"turn_rate_rad_per_s", &Drive::turn_rate_rad_per_s, Allowed::number(0.01, 100.0), "rad/s",
         "The robot turns no faster."},
        {"turn_acceleration_rad_per_s2", &Drive::turn_acceleration_rad_per_s2, Allowed::number(0.01, 1000.0), "rad/s^2",
         "The turn rate changes no faster."},
        {"turn_in_place_above_rad", &Drive::turn_in_place_above_rad, Allowed::number(0.01, 3.15), "rad",
         "The robot turns away a larger error of the heading standing still."},
        {"lookahead_m", &Drive::lookahead_m, Allowed::number(0.01, 100.0), "m",
         "The robot steers for the point this far ahead on the line between way points.", "pure pursuit, Coulter 1992"},
    };
    return rows;
}

const SettingTable<ImuSettings>& imu_rows() {
    using Imu = ImuSettings;
    static const SettingTable<Imu> rows{
        {"rate_hz", &Imu::rate_hz, Allowed::number(0.0, 10000.0), "Hz",
         "Number of readings of an inertial sensor per second; 0: there is none."},
        {"bias_sd_rad_per_s", &Imu::bias_sd_rad_per_s, Allowed::number(0.0, 10.0), "rad/s",
         "Standard deviation over runs of what its gyro reads at rest."},
        {"noise_rad_per_sqrt_s", &Imu::noise_rad_per_sqrt_s, Allowed::number(0.0, 10.0), "rad/sqrt(s)",
         "Standard deviation of the turn that its gyro measures in a second."},
    };
    return rows;
}

/// The settings of a group that has a preset: first the name of the preset, then the values. A value that is null is
/// taken from the preset, and docs/simulator.md has the sources of the presets.
std::vector<Setting> with_preset(const std::string& meaning, const std::vector<Setting>& rows) {
    std::vector<Setting> settings{{"preset", Allowed::text(), "", meaning, "docs/simulator.md", {}}};
    settings.insert(settings.end(), rows.begin(), rows.end());
    return settings;
}

/// The name of a preset, and null for every value that it sets.
Json preset_keys(const std::string& preset, const Json& values) {
    Json keys{{"preset", preset}};
    for (const auto& item : values.items()) {
        keys[item.key()] = nullptr;
    }
    return keys;
}

/// The values of the preset, except those that the configuration gives.
Json resolved(Json preset, const Json& configured) {
    for (const auto& [key, value] : configured.items()) {
        if (key != "preset" && !value.is_null()) {
            preset[key] = value;
        }
    }
    return preset;
}

/// Throws UsageError unless `good`. For checks that the table cannot express, because they concern more than one value.
void expect(bool good, const std::string& path, const std::string& key, const std::string& expected) {
    if (!good) {
        throw UsageError(below(path, key) + ": expected " + expected);
    }
}

LidarSettings lidar_from(const Json& json, const std::string& path) {
    const std::string group = below(path, "lidar");
    const Json values = resolved(lidar_rows().json(lidar_preset(json.at("preset").get<std::string>())), json);
    const LidarSettings lidar = lidar_rows().checked(values, group);
    expect(lidar.range_min_m < lidar.range_max_m, group, "range_max_m", "more than range_min_m");
    expect(lidar.range_noise_m > 0.0 || lidar.range_noise_per_m > 0.0, group, "range_noise_m",
           "a number above 0, since the Fisher information divides by it");
    return lidar;
}

std::vector<Pose2> more_lasers_from(const Json& numbers, const std::string& path) {
    expect_allowed(numbers, more_lasers, "", below(path, "more_lasers"));
    expect(numbers.size() % 3 == 0, path, "more_lasers",
           "three numbers for each lidar: x, y in metres, theta in radians");
    std::vector<Pose2> poses;
    for (std::size_t first = 0; first < numbers.size(); first += 3) {
        poses.push_back({numbers[first], numbers[first + 1], numbers[first + 2]});
    }
    return poses;
}

OdometrySettings odometry_from(const Json& json, const std::string& path) {
    const std::string group = below(path, "odometry");
    const auto preset = odometry_preset(json.at("preset").get<std::string>());
    return odometry_rows().checked(resolved(odometry_rows().json(preset), json), group);
}

}  // namespace

std::vector<Setting> simulation_setting_list() {
    return {{"world",
             Allowed::text(),
             "",
             "The world to drive through: a name, or a file of one.",
             "docs/simulator.md",
             {}},
            {"seed", Allowed::seed(), "", "The noise of the sensors follows from it; the way driven does not.", "", {}},
            {"start_ns", start_ns, "ns", "Stamp of the first pose.", "", {}},
            {"robot_from_laser", {}, "", "", "", pose_rows().settings()},
            {"lidar", {}, "", "", "", with_preset("The sensor; it gives what is null below.", lidar_rows().settings())},
            {"odometry",
             {},
             "",
             "",
             "",
             with_preset("How well the wheels measure; it gives what is null below.", odometry_rows().settings())},
            {"imu", {}, "", "", "", imu_rows().settings()},
            {"more_lasers",
             more_lasers,
             "",
             "Poses of further lidars of the same kind on the robot, for each x and y in metres and theta in radians.",
             "docs/simulator.md",
             {}},
            {"drive", {}, "", "", "", drive_rows().settings()}};
}

Json default_simulation_json() {
    const SimulationSettings defaults;
    return {{"world", "s2"},
            {"seed", defaults.seed},
            {"start_ns", defaults.start_ns},
            {"robot_from_laser", pose_rows().json(defaults.robot_from_laser)},
            {"lidar", preset_keys("ls-m10p", lidar_rows().json(defaults.lidar))},
            {"odometry", preset_keys("typical", odometry_rows().json(defaults.odometry))},
            {"imu", imu_rows().json(defaults.imu)},
            {"more_lasers", Json::array()},
            {"drive", drive_rows().json(defaults.drive)}};
}

Json common_simulation_json() {
    Json json = default_simulation_json();
    for (const char* key : not_common) {
        json.erase(key);
    }
    return json;
}

std::vector<Setting> common_simulation_setting_list() {
    std::vector<Setting> settings = simulation_setting_list();
    for (const char* key : not_common) {
        settings = without(std::move(settings), key);
    }
    return settings;
}

SimulationSettings simulation_from_json(const Json& json, const std::string& path) {
    expect_allowed(json.at("seed"), Allowed::seed(), "", below(path, "seed"));
    expect_allowed(json.at("start_ns"), start_ns, "ns", below(path, "start_ns"));
    return {.seed = json.at("seed").get<std::uint64_t>(),
            .start_ns = json.at("start_ns").get<std::int64_t>(),
            .robot_from_laser = pose_rows().checked(json.at("robot_from_laser"), below(path, "robot_from_laser")),
            .more_lasers = more_lasers_from(json.value("more_lasers", Json::array()), path),
            .lidar = lidar_from(json.at("lidar"), path),
            .odometry = odometry_from(json.at("odometry"), path),
            .imu = json.contains("imu") ? imu_rows().checked(json.at("imu"), below(path, "imu")) : ImuSettings{},
            .drive = drive_rows().checked(json.at("drive"), below(path, "drive"))};
}

}  // namespace ddtool::sim
