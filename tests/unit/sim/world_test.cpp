#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ddtool/base/error.hpp"
#include "sim/drive.hpp"
#include "sim/ray_caster.hpp"
#include "sim/texture.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_json.hpp"

namespace ddtool::sim {
namespace {

constexpr double robot_radius_m = 0.25;

double length_of_walls(const World& world) {
    double sum = 0.0;
    for (const Segment& segment : world.segments) {
        sum += std::hypot(segment.b.x_m - segment.a.x_m, segment.b.y_m - segment.a.y_m);
    }
    return sum;
}

double clearance_m(const Pose2& robot, const RayCaster& caster) {
    double least_m = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 90; ++i) {
        const auto hit = caster.cast(ray_at({robot.x_m, robot.y_m}, 2.0 * std::numbers::pi * i / 90.0), 2.0);
        least_m = hit ? std::min(least_m, hit->range_m) : least_m;
    }
    return least_m;
}

std::vector<std::string> many_worlds() {
    std::vector<std::string> names;
    for (const WorldEntry& entry : list_worlds()) {
        const std::string stem = entry.name.substr(0, entry.name.find("SEED"));
        for (int seed = 0; seed < (stem == entry.name ? 1 : 10); ++seed) {
            const std::string name = stem == entry.name ? stem : stem + std::to_string(seed);
            names.push_back(name);
            names.push_back(name + "-textured");
        }
    }
    return names;
}

class AnyWorld : public testing::TestWithParam<std::string> {};

TEST_P(AnyWorld, CanBeDrivenWithoutTouchingAnything) {
    const World world = load_world(GetParam());
    const RayCaster caster(world);
    const Trajectory trajectory = drive(world.route, {}, 0, 50'000'000);
    EXPECT_GT(trajectory.size(), 200U);
    for (std::size_t i = 0; i < trajectory.size(); i += 4) {
        ASSERT_GT(clearance_m(trajectory[i].pose, caster), robot_radius_m)
            << "at " << trajectory[i].pose.x_m << ", " << trajectory[i].pose.y_m;
    }
}

TEST_P(AnyWorld, IsTheSameEachTimeAndHasSomethingToSee) {
    const World once = load_world(GetParam());
    const World twice = load_world(GetParam());
    EXPECT_GT(once.segments.size() + once.arcs.size(), 3U);
    EXPECT_EQ(once.name, GetParam());
    EXPECT_EQ(length_of_walls(once), length_of_walls(twice));
    EXPECT_EQ(once.route.way_points, twice.route.way_points);
}

INSTANTIATE_TEST_SUITE_P(All, AnyWorld, testing::ValuesIn(many_worlds()), [](const auto& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

TEST(RandomWorlds, DifferBySeed) {
    for (const char* kind : {"random:office:", "random:corridors:", "random:open:"}) {
        EXPECT_NE(load_world(std::string(kind) + "1").route.way_points,
                  load_world(std::string(kind) + "2").route.way_points);
    }
}

TEST(Texture, LeavesTheRouteAndAddsSurface) {
    const World plain = load_world("s2");
    const World rough = textured(plain);
    EXPECT_EQ(rough.route.way_points, plain.route.way_points);
    EXPECT_GT(length_of_walls(rough), length_of_walls(plain));
    for (const Segment& segment : rough.segments) {
        EXPECT_LE(std::abs(segment.a.y_m), 0.65 + 1e-9);  // the wall is at 0.5 m, and its surface at most 15 cm behind
        EXPECT_GE(std::hypot(segment.a.x_m, segment.a.y_m), 0.3);
    }
}

TEST(WorldFile, HoldsWallsBoxesCirclesAndArcs) {
    const World world = world_from_json(Json::parse(R"({
        "name": "test", "start": [1, 2, 90], "way_points": [[1, 5]],
        "walls": [[[0, 0], [1, 0], [1, 1]]],
        "boxes": [{"centre": [5, 5], "size": [2, 1]}],
        "circles": [{"centre": [3, 3], "radius_m": 0.5}],
        "arcs": [{"centre": [0, 0], "radius_m": 2, "from_deg": 90, "to_deg": 180}]})"),
                                        "test.json");
    EXPECT_EQ(world.segments.size(), 2U + 4U);
    ASSERT_EQ(world.arcs.size(), 2U);
    EXPECT_NEAR(world.arcs[0].sweep_rad, 2.0 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(world.arcs[1].sweep_rad, std::numbers::pi / 2.0, 1e-12);
    EXPECT_NEAR(world.route.start.theta_rad, std::numbers::pi / 2.0, 1e-12);
}

struct BadFile {
    const char* text;
    const char* says;
};

class BadWorldFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadWorldFile, IsRefusedWithTheKey) {
    try {
        world_from_json(Json::parse(GetParam().text), "bad.json");
        FAIL() << "expected a UsageError";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().says), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("bad.json"), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadWorldFile,
    testing::Values(BadFile{R"({"way_point": [[1, 2]]})", "way_points"},  // the message names the nearest known key
                    BadFile{R"({"way_points": []})", "way_points"}, BadFile{R"({"way_points": [[1]]})", "way_points"},
                    BadFile{R"({"way_points": [[1, "two"]]})", "way_points"},
                    BadFile{R"({"way_points": [[1, 2]], "start": [0, 0]})", "start"},
                    BadFile{R"({"way_points": [[1, 2]], "laps": 0})", "laps"},
                    BadFile{R"({"way_points": [[1, 2]], "laps": 1e15})", "laps"},
                    BadFile{R"({"way_points": [[1, 2]], "walls": [[0, 1]]})", "walls[0]"},
                    BadFile{R"({"way_points": [[1, 2]], "boxes": [{"size": [1, 1], "depth": 3}]})", "depth"},
                    BadFile{R"({"way_points": [[1, 2]], "boxes": [{}, {"size": [1]}]})", "boxes[1].size"},
                    BadFile{R"({"way_points": [[1, 2]], "circles": [{"radius_m": -1}]})", "circles[0].radius_m"},
                    BadFile{R"({"way_points": [[1, 2]], "arcs": [{"from_deg": 90, "to_deg": 80}]})", "from_deg"}));

TEST(WorldCatalogue, NamesWhatItKnowsWhenAskedForSomethingElse) {
    for (const char* name : {"s9", "random:forest:1", "random:office", "random:office:x", "random:office:-3"}) {
        EXPECT_THROW(load_world(name), UsageError) << name;
    }
}

}  // namespace
}  // namespace ddtool::sim
