#include "localization/global_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "known_places.hpp"

namespace ddtool::localization {
namespace {

using test::drive;
using test::true_map;

TEST(GlobalSearch, FindsTheRobotWhereverItIs) {
    const auto map = true_map(drive(test::two_rooms(), 1));
    GlobalSearch search(*map, {});
    const std::vector<SensorFrame> frames = drive(test::two_rooms(), 2);
    std::size_t found = 0;
    std::size_t tried = 0;
    for (std::size_t i = 0; i < frames.size(); i += frames.size() / 12) {
        ++tried;
        const FoundPlaces places = search.search(scan_points(frames[i], {}));
        EXPECT_TRUE(places.complete);
        for (const FoundPlace& place : places.places) {
            if (distance_m(place.pose, *frames[i].world_from_robot) < 0.1 &&
                std::abs(wrap_angle(place.pose.theta_rad - frames[i].world_from_robot->theta_rad)) < 0.05) {
                ++found;
                EXPECT_GT(place.fit.support(), 0.9);
                break;
            }
        }
    }
    EXPECT_EQ(found, tried);
}

/// In a square room every quarter turn fits.
TEST(GlobalSearch, FindsAllPlacesThatFit) {
    sim::World world{.name = "square", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_box(world, {}, 5.0, 5.0);
    world.route = {.start = {0.7, 0.4, 0.3}, .way_points = {{1.5, 1.0}}};
    const std::vector<SensorFrame> frames = drive(world, 1);
    const auto map = true_map(frames);
    const FoundPlaces places = GlobalSearch(*map, {}).search(scan_points(frames.front(), {}));
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Pose2 turned = Pose2{0.0, 0.0, quarter * M_PI / 2} * Pose2{0.7, 0.4, 0.3};
        EXPECT_TRUE(std::ranges::any_of(places.places, [&](const FoundPlace& place) {
            return distance_m(place.pose, turned) < 0.1;
        })) << quarter;
    }
}

TEST(GlobalSearch, FindsNothingWhereNothingIs) {
    const OccupancyGrid empty({});
    const std::vector<SensorFrame> frames = drive(test::two_rooms(), 1);
    EXPECT_TRUE(GlobalSearch(empty, {}).search(scan_points(frames.front(), {})).places.empty());
    EXPECT_TRUE(GlobalSearch(*true_map(frames), {}).search({}).places.empty());
}

}  // namespace
}  // namespace ddtool::localization
