#include "sim/simulation_json.hpp"

#include <gmock/gmock.h>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

Json with(const std::vector<std::string>& assignments) {
    Json settings = default_simulation_json();
    for (const std::string& assignment : assignments) {
        merge_assignment(settings, assignment);
    }
    return settings;
}

std::string refusal(const std::string& assignment) {
    try {
        simulation_from_json(with({assignment}));
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(SimulationJson, DefaultsAreThoseOfTheStructs) {
    const SimulationSettings settings = simulation_from_json(default_simulation_json());
    const SimulationSettings defaults;
    EXPECT_EQ(settings.seed, defaults.seed);
    EXPECT_EQ(settings.start_ns, defaults.start_ns);
    EXPECT_EQ(settings.lidar.beams, defaults.lidar.beams);
    EXPECT_EQ(settings.odometry.scale_error_sd, defaults.odometry.scale_error_sd);
    EXPECT_EQ(settings.drive.lookahead_m, defaults.drive.lookahead_m);
}

TEST(SimulationJson, APresetGivesEveryValueThatIsNotSet) {
    const SimulationSettings settings =
        simulation_from_json(with({"lidar.preset=sick-lms", "lidar.range_max_m=20", "odometry.preset=poor"}));
    EXPECT_EQ(settings.lidar.beams, lidar_preset("sick-lms").beams);
    EXPECT_EQ(settings.lidar.range_max_m, 20.0);
    EXPECT_EQ(settings.odometry.slip_m, odometry_preset("poor").slip_m);
}

TEST(SimulationJson, SetsTheMountingAndTheDrive) {
    const SimulationSettings settings =
        simulation_from_json(with({"robot_from_laser.x_m=0.2", "drive.speed_m_per_s=0.4", "seed=7"}));
    EXPECT_EQ(settings.robot_from_laser, (Pose2{0.2, 0.0, 0.0}));
    EXPECT_EQ(settings.drive.speed_m_per_s, 0.4);
    EXPECT_EQ(settings.seed, 7U);
}

TEST(SimulationJson, NamesTheKeyOfAValueThatMakesNoSense) {
    for (const std::string key :
         {"lidar.beams=1", "lidar.field_of_view_rad=7", "lidar.rate_hz=0", "lidar.range_max_m=0.01",
          "lidar.drop_out_probability=1.5", "lidar.beam_divergence_rad=-1", "odometry.rate_hz=0",
          "odometry.slip_m=-0.1", "lidar.beams=many", "lidar.motion_distortion=3"}) {
        EXPECT_THAT(refusal(key), testing::HasSubstr(key.substr(0, key.find('=')))) << key;
    }
    EXPECT_THAT(refusal("lidar.preset=velodyne"), testing::HasSubstr("velodyne"));
    EXPECT_THAT(refusal("lidar.range_noise_m=0"), testing::HasSubstr("range_noise_m"));
}

}  // namespace
}  // namespace ddtool::sim
