#include "merging/map_merge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "driven_maps.hpp"
#include "maps/map_edit.hpp"
#include "thrown_text.hpp"

namespace ddtool::merging {
namespace {

using ddtool::test::thrown_text;
using test::map_of;

bool left_part(const Pose2& pose) { return pose.x_m < 8.5; }
bool right_part(const Pose2& pose) { return pose.x_m > 1.0; }

std::string why_not(const maps::SavedMap& first, const maps::SavedMap& second) {
    return thrown_text([&] { static_cast<void>(merged(first, second)); });
}

TEST(MapMerge, TwoPartsOfAPlaceBecomeOneMap) {
    const Pose2 origin{4.0, -1.0, 2.0};
    const maps::SavedMap first = map_of(test::two_rooms(), 1, {}, left_part);
    const maps::SavedMap second = map_of(test::two_rooms(), 2, origin, right_part);
    const Merged both = merged(first, second);
    EXPECT_LT(distance_m(both.first_from_second, origin), 0.03);
    EXPECT_LT(std::abs(wrap_angle(both.first_from_second.theta_rad - origin.theta_rad)), 0.005);
    EXPECT_GT(both.agreed, 0.95);
    EXPECT_EQ(both.map.nodes.size(), first.nodes.size() + second.nodes.size());
    ASSERT_EQ(both.map.drives.size(), 2U);
    EXPECT_EQ(both.map.drives[1].log, second.drives[0].log);
    EXPECT_EQ(both.map.nodes.back().drive, 1U);
    EXPECT_EQ(both.map.nodes.front().pose, first.nodes.front().pose);  // the origin stays
    for (std::size_t node = 0; node < second.nodes.size(); ++node) {
        EXPECT_LT(distance_m(both.map.nodes[first.nodes.size() + node].pose, origin * second.nodes[node].pose), 0.05);
    }
    std::size_t between_both = 0;
    for (const maps::MapEdge& edge : both.map.edges) {
        const bool ties = edge.edge.from < first.nodes.size() && edge.edge.to >= first.nodes.size();
        between_both += ties ? 1 : 0;
        EXPECT_LT(edge.edge.to, both.map.nodes.size());
    }
    EXPECT_EQ(between_both, both.seams);
    EXPECT_GE(both.seams, 3U);
    EXPECT_LT(both.most_moved_m, 0.05);
    const CellBox box = both.map.grid.observed_box();
    EXPECT_LT(box.x_min * 0.05, -1.9);
    EXPECT_GT(box.x_max * 0.05, 13.9);
}

TEST(MapMerge, TheOrderOfTheFilesDoesNotMatterForThePlace) {
    const Pose2 origin{4.0, -1.0, 2.0};
    const maps::SavedMap first = map_of(test::two_rooms(), 1, {}, left_part);
    const maps::SavedMap second = map_of(test::two_rooms(), 2, origin, right_part);
    const Merged both = merged(second, first);
    EXPECT_LT(distance_m(both.first_from_second, inverse(origin)), 0.03);
}

TEST(MapMerge, PartsWithoutOverlapAreRefused) {
    const maps::SavedMap first = map_of(test::two_rooms(), 1, {}, [](const Pose2& pose) { return pose.x_m < 1.0; });
    const maps::SavedMap second = map_of(test::two_rooms(), 2, {}, [](const Pose2& pose) { return pose.x_m > 10.0; });
    EXPECT_NE(why_not(first, second).find("no overlap"), std::string::npos) << why_not(first, second);
}

TEST(MapMerge, AnotherPlaceIsRefused) {
    const maps::SavedMap first = map_of(test::two_rooms(), 1, {}, test::anywhere);
    const maps::SavedMap second = map_of(test::hall(), 2, {}, test::anywhere);
    EXPECT_NE(why_not(first, second), "");
    EXPECT_NE(why_not(second, first), "");
}

/// The second map shows one of two rooms that look alike.
TEST(MapMerge, TwoPlacesThatFitAreRefused) {
    const maps::SavedMap both = map_of(test::twin_rooms(), 1, {}, test::anywhere);
    const maps::SavedMap one =
        map_of(test::twin_rooms(), 2, {1.0, 0.0, 0.3}, [](const Pose2& pose) { return pose.x_m > 9.0; });
    EXPECT_NE(why_not(both, one).find("more than one place"), std::string::npos) << why_not(both, one);
}

TEST(MapMerge, TheSameDriveIsRefused) {
    const maps::SavedMap one = map_of(test::two_rooms(), 1, {}, test::anywhere);
    const maps::SavedMap part = map_of(test::two_rooms(), 1, {1.0, 0.0, 0.0}, left_part);
    EXPECT_NE(why_not(one, part).find("same drive"), std::string::npos) << why_not(one, part);
}

TEST(MapMerge, TheSameDriveIsRecognisedWherePointsWereTakenOut) {
    const maps::SavedMap one = map_of(test::two_rooms(), 1, {}, test::anywhere);
    maps::SavedMap cropped = one;
    maps::crop(cropped, {-5.0, -5.0, 6.0, 5.0});
    EXPECT_NE(why_not(one, cropped).find("same drive"), std::string::npos) << why_not(one, cropped);
    EXPECT_NE(why_not(cropped, one).find("same drive"), std::string::npos) << why_not(cropped, one);
}

/// Simulated drives of one seed begin with the same stamps and odometry, wherever they are.
TEST(MapMerge, DrivesOfOneSeedInDifferentPlacesAreNotTheSameDrive) {
    const maps::SavedMap rooms = map_of(test::two_rooms(), 1, {}, test::anywhere);
    const maps::SavedMap hall = map_of(test::hall(), 1, {}, test::anywhere);
    EXPECT_EQ(why_not(rooms, hall).find("same drive"), std::string::npos) << why_not(rooms, hall);
    EXPECT_NE(why_not(rooms, hall), "");
}

TEST(MapMerge, APictureIsRefused) {
    const maps::SavedMap map = map_of(test::two_rooms(), 1, {}, left_part);
    maps::SavedMap picture{OccupancySettings{}};
    picture.grid = map.grid;
    EXPECT_NE(why_not(map, picture).find("the second has no scans"), std::string::npos);
    EXPECT_NE(why_not(picture, map).find("the first has no scans"), std::string::npos);
}

TEST(MapMerge, SameMapsSameBytes) {
    const maps::SavedMap first = map_of(test::two_rooms(), 1, {}, left_part);
    const maps::SavedMap second = map_of(test::two_rooms(), 2, {4.0, -1.0, 2.0}, right_part);
    const Merged one = merged(first, second);
    const Merged other = merged(first, second);
    for (std::size_t node = 0; node < one.map.nodes.size(); ++node) {
        EXPECT_EQ(one.map.nodes[node].pose, other.map.nodes[node].pose);
    }
}

}  // namespace
}  // namespace ddtool::merging
