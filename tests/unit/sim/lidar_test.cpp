#include "sim/lidar.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

constexpr LidarSettings ideal{.beams = 720,
                              .range_noise_m = 0.0,
                              .range_resolution_m = 0.0,
                              .drop_out_probability = 0.0,
                              .beam_divergence_rad = 0.0};

std::vector<float> scan_in(const World& world, const LidarSettings& settings, std::uint64_t seed) {
    const RayCaster caster(world);
    const LaserScan scan = blank_scan(settings, 0);
    const std::vector<Pose2> laser{{0.0, 0.0, 0.0}};
    return measure_ranges(scan, laser, cast_beams(scan, laser, caster), caster, settings, RandomStream({seed}));
}

World round_room(double radius_m) {
    World world;
    world.arcs.push_back({.centre = {}, .radius_m = radius_m});
    return world;
}

TEST(Lidar, WithoutErrorsMeasuresTheRange) {
    for (const float range : scan_in(round_room(4.0), ideal, 1)) {
        EXPECT_NEAR(range, 4.0, 1e-6);
    }
}

TEST(Lidar, NothingInRangeIsNoReturn) {
    for (const float range : scan_in(round_room(40.0), ideal, 1)) {
        EXPECT_EQ(range, LaserScan::no_return);
    }
}

TEST(Lidar, NoiseHasTheStatedSpread) {
    LidarSettings settings = ideal;
    settings.beams = 20'000;
    settings.range_noise_m = 0.01;
    settings.range_noise_per_m = 0.005;
    double squares = 0.0;
    for (const float range : scan_in(round_room(4.0), settings, 1)) {
        squares += std::pow(range - 4.0, 2);
    }
    const double sd = 0.01 + 0.005 * 4.0;
    EXPECT_NEAR(std::sqrt(squares / settings.beams), sd, 5.0 * sd / std::sqrt(2.0 * settings.beams));
}

TEST(Lidar, RangesAreMultiplesOfTheResolution) {
    LidarSettings settings = ideal;
    settings.range_noise_m = 0.05;
    settings.range_resolution_m = 0.25;
    const std::vector<float> exact = scan_in(round_room(4.0), {.beams = 720, .range_noise_m = 0.05}, 1);
    for (const float range : scan_in(round_room(4.0), settings, 1)) {
        EXPECT_EQ(std::fmod(range, 0.25F), 0.0F);
    }
    EXPECT_NE(std::fmod(exact[0], 0.25F), 0.0F);
}

TEST(Lidar, DropsOutAsOftenAsStated) {
    LidarSettings settings = ideal;
    settings.beams = 20'000;
    settings.drop_out_probability = 0.1;
    int invalid = 0;
    for (const float range : scan_in(round_room(4.0), settings, 1)) {
        invalid += std::isnan(range) ? 1 : 0;
    }
    EXPECT_NEAR(invalid, 2000.0, 5.0 * std::sqrt(20'000 * 0.1 * 0.9));
}

TEST(Lidar, EdgesMixTheRangesOnBothSidesAndNothingElseDoes) {
    World world = round_room(8.0);
    add_box(world, {3.0, 0.0, 0.0}, 0.1, 2.0);
    LidarSettings settings = ideal;
    settings.beam_divergence_rad = 2.0 * std::numbers::pi / settings.beams;
    const std::vector<float> clean = scan_in(world, ideal, 1);
    const std::vector<float> mixed = scan_in(world, settings, 1);
    int between = 0;
    for (std::size_t beam = 0; beam < clean.size(); ++beam) {
        if (std::abs(mixed[beam] - clean[beam]) > 0.01F) {
            EXPECT_GT(mixed[beam], 2.9F);
            EXPECT_LT(mixed[beam], 8.0F);
            ++between;
        }
    }
    EXPECT_EQ(between, 2);  // one beam at each side of the box
}

TEST(Lidar, BeamsSpanTheFieldOfView) {
    const LaserScan full = blank_scan(ideal, 0);
    EXPECT_NEAR(full.angle_rad(720) - full.angle_rad(0), 2.0 * std::numbers::pi, 1e-9);
    const LidarSettings hokuyo = lidar_preset("hokuyo-utm-30lx");
    const LaserScan part = blank_scan(hokuyo, 0);
    EXPECT_NEAR(part.angle_rad(1080), -part.angle_min_rad, 1e-9);
    EXPECT_NEAR(part.angle_increment_rad, 0.25 * std::numbers::pi / 180.0, 1e-9);
}

TEST(Lidar, EveryPresetIsKnownAndOthersAreRefused) {
    for (const std::string& name : lidar_preset_names()) {
        const LidarSettings settings = lidar_preset(name);
        EXPECT_LT(settings.range_min_m, settings.range_max_m) << name;
    }
    EXPECT_THROW(lidar_preset("velodyne"), UsageError);
}

}  // namespace
}  // namespace ddtool::sim
