#include "bench_worlds.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ddtool/base/error.hpp"
#include "drive_through.hpp"
#include "sim/lidar.hpp"

namespace ddtool::matcher_bench {
namespace {

constexpr double short_drive_m = 25.0;

std::vector<Place> few_beams_through(const BenchWorld& world) {
    return drive_through(world, {.beams = 72, .range_max_m = 30.0}, {}, 1);
}

TEST(BenchWorlds, AreDrivenThroughWithoutTouchingAWall) {
    constexpr double robot_m = 0.3;
    for (const WorldKind& kind : world_kinds()) {
        for (std::uint64_t layout = 1; layout <= 8; ++layout) {
            for (const Place& place : few_beams_through(draw_world(kind.name, layout, short_drive_m))) {
                for (const float range_m : place.frame.scan.ranges_m) {
                    ASSERT_FALSE(range_m < robot_m) << kind.name << "-" << layout << " after " << place.way_m << " m";
                }
            }
        }
    }
}

TEST(BenchWorlds, OfOneLayoutAreTheSameAndOfTwoDiffer) {
    for (const WorldKind& kind : world_kinds()) {
        const sim::World first = draw_world(kind.name, 2, short_drive_m).world;
        const sim::World again = draw_world(kind.name, 2, short_drive_m).world;
        const sim::World other = draw_world(kind.name, 3, short_drive_m).world;
        EXPECT_EQ(first.segments.back().b, again.segments.back().b) << kind.name;
        EXPECT_NE(first.segments.back().b, other.segments.back().b) << kind.name;
    }
}

/// An end wall would hold the robot along the corridor.
TEST(BenchWorlds, CorridorsShowNoEnd) {
    for (const Place& place : few_beams_through(draw_world("bare", 2, short_drive_m))) {
        const Eigen::Vector3d along(std::cos(place.along_rad - place.pose().theta_rad),
                                    std::sin(place.along_rad - place.pose().theta_rad), 0.0);
        ASSERT_NEAR(along.dot(place.information * along), 0.0, 1e-6);
    }
}

TEST(BenchWorlds, HoldTheRobotAlongUnlessTheyAreBare) {
    for (const WorldKind& kind : world_kinds()) {
        if (kind.name != "bare") {
            double information = 0.0;
            const std::vector<Place> places = few_beams_through(draw_world(kind.name, 1, short_drive_m));
            for (const Place& place : places) {
                information += place.information(0, 0);
            }
            EXPECT_GT(information / static_cast<double>(places.size()), 1.0 / (0.03 * 0.03)) << kind.name;
        }
    }
}

TEST(BenchWorlds, OfAnUnknownKindAreRefusedWithTheNamesThatThereAre) {
    try {
        draw_world("attic", 1, short_drive_m);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("'attic'"), testing::HasSubstr("recesses")));
    }
}

}  // namespace
}  // namespace ddtool::matcher_bench
