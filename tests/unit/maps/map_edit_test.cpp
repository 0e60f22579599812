#include "maps/map_edit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "ddtool/filter/scan_insertion.hpp"
#include "maps/ply_file.hpp"
#include "small_map.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::maps {
namespace {

using test::small_map;

std::size_t occupied_cells(const OccupancyGrid& grid) {
    std::size_t count = 0;
    const CellBox box = grid.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            count += grid.occupied({x, y}) ? 1 : 0;
        }
    }
    return count;
}

/// A round wall about the robot, seen from its centre, with a post before it where asked.
ScanPoints round_scan(double radius_m, bool with_post) {
    ScanPoints points;
    constexpr int beams = 360;
    for (int i = 0; i < beams; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / beams;
        const bool post = with_post && i >= 40 && i < 50;
        const double range = post ? 0.5 * radius_m : radius_m;
        points.x_m.push_back(static_cast<float>(range * std::cos(angle)));
        points.y_m.push_back(static_cast<float>(range * std::sin(angle)));
        points.normal_x.push_back(static_cast<float>(-std::cos(angle)));
        points.normal_y.push_back(static_cast<float>(-std::sin(angle)));
        points.along_weight.push_back(0.0F);
        points.order.push_back(points.order.empty() ? 0 : points.order.back() + (i == 40 || i == 50 ? 2 : 1));
    }
    return points;
}

/// A room in which a post stood during the first scans.
SavedMap room_with_ghost(int scans_with, int scans_without) {
    SavedMap map{OccupancySettings{}};
    map.drives = {{.log = "room", .odometry = {}}};
    for (int i = 0; i < scans_with + scans_without; ++i) {
        MapNode node;
        node.scan.points = graph::PackedScan(round_scan(3.0, i < scans_with));
        node.pose = {0.01 * (i % 3), 0.0, 0.0};
        node.scan.odom_from_robot = node.pose;
        map.nodes.push_back(std::move(node));
    }
    map.grid = drawn(map.nodes, {});
    return map;
}

TEST(MapEdit, WhatLaterScansSawThroughGoesAway) {
    SavedMap map = room_with_ghost(8, 8);
    const std::size_t before = occupied_cells(map.grid);
    const std::size_t removed = remove_ghosts(map, 5);
    EXPECT_GT(removed, 3U);
    EXPECT_EQ(occupied_cells(map.grid), before - removed);
    // The wall is still there: a ring of 3 m has about 2 pi 3 / 0.05 = 377 cells.
    EXPECT_GT(occupied_cells(map.grid), 300U);
    for (int y = -40; y < 40; ++y) {
        for (int x = -40; x < 40; ++x) {
            EXPECT_FALSE(map.grid.occupied({x, y})) << x << ' ' << y;
        }
    }
    // Drawn anew from its scans, the map is the same: the ghost is gone from them, too.
    EXPECT_TRUE(test::same_cells(map.grid, drawn(map.nodes, map.grid.settings())));
}

TEST(MapEdit, WhatWasSeenToTheEndStays) {
    SavedMap map = room_with_ghost(8, 3);
    const auto in_post = [&] {
        std::size_t count = 0;
        for (int y = -40; y < 40; ++y) {
            for (int x = -40; x < 40; ++x) {
                count += map.grid.occupied({x, y}) ? 1 : 0;
            }
        }
        return count;
    };
    const std::size_t before = in_post();
    EXPECT_GT(before, 3U);
    EXPECT_LT(remove_ghosts(map, 5), 8U);  // single cells beside the wall, which few scans hit
    EXPECT_EQ(in_post(), before);
}

TEST(MapEdit, GhostsNeedScans) {
    SavedMap picture{OccupancySettings{}};
    EXPECT_NE(ddtool::test::thrown_text([&] { remove_ghosts(picture, 5); }), "");
}

TEST(MapEdit, CroppingLeavesTheAreaAlone) {
    SavedMap map = small_map();
    const Area area{-1.0, -1.0, 2.0, 1.0};
    const std::size_t left = crop(map, area);
    EXPECT_GT(left, 0U);
    EXPECT_LT(left, small_map().nodes.size());
    for (const MapNode& node : map.nodes) {
        EXPECT_TRUE(area.holds({node.pose.x_m, node.pose.y_m}));
    }
    const auto outside = [&](const OccupancyGrid& grid) {
        const CellBox box = grid.observed_box();
        std::size_t count = 0;
        for (int y = box.y_min; y < box.y_max; ++y) {
            for (int x = box.x_min; x < box.x_max; ++x) {
                const bool in = area.holds({(x + 0.5) * 0.05, (y + 0.5) * 0.05});
                count += !in && grid.occupied({x, y}) ? 1 : 0;
                if (in) {
                    EXPECT_EQ(grid.log_odds({x, y}) > 0, map.grid.log_odds({x, y}) > 0);
                }
            }
        }
        return count;
    };
    EXPECT_EQ(outside(map.grid), 0U);
    EXPECT_LE(occupied_cells(drawn(map.nodes, map.grid.settings())), occupied_cells(small_map().grid));
}

TEST(MapEdit, CroppingKeepsTheEdgesOfWhatIsLeft) {
    SavedMap map = small_map();
    map.edges = {{MapEdge::Kind::match, {.from = 0, .to = 1, .measured = {}}}};
    const std::size_t last = map.nodes.size() - 1;
    map.edges.push_back({MapEdge::Kind::match, {.from = last - 1, .to = last, .measured = {}}});
    const Point2 end{map.nodes[last].pose.x_m, map.nodes[last].pose.y_m};
    const std::size_t left = crop(map, {end.x_m - 0.7, end.y_m - 0.7, end.x_m + 0.7, end.y_m + 0.7});
    ASSERT_EQ(map.edges.size(), 1U);
    EXPECT_EQ(map.edges[0].edge.to, left - 1);
    EXPECT_EQ(map.edges[0].edge.from, left - 2);
}

TEST(MapEdit, TheOriginIsWhereItWasSet) {
    SavedMap map = small_map();
    const Pose2 origin = map.nodes[3].pose;
    set_origin(map, origin);
    EXPECT_NEAR(map.nodes[3].pose.x_m, 0.0, 1e-12);
    EXPECT_NEAR(map.nodes[3].pose.theta_rad, 0.0, 1e-12);
    const Pose2 back = inverse(origin);
    set_origin(map, back);
    std::size_t different = 0;
    const CellBox box = small_map().grid.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            different += map.grid.occupied({x, y}) != small_map().grid.occupied({x, y}) ? 1 : 0;
        }
    }
    EXPECT_LT(different, occupied_cells(small_map().grid) / 30);
}

/// The cells of a picture are moved as they are: a wall stays a wall without holes.
TEST(MapEdit, APictureIsTurnedWithoutHoles) {
    SavedMap map{OccupancySettings{}};
    map.grid.reserve({-100, -100, 100, 100});
    for (int x = -80; x < 80; ++x) {
        for (int y = -20; y < 20; ++y) {
            map.grid.set({x, y}, y == 19 ? 60 : -30, {});
        }
    }
    set_origin(map, {0.5, 0.2, 0.7});
    const auto value = [&](double x_m, double y_m) {
        const Point2 at = inverse(Pose2{0.5, 0.2, 0.7}) * Point2{x_m, y_m};
        return map.grid.log_odds(
            {static_cast<int>(std::floor(at.x_m / 0.05)), static_cast<int>(std::floor(at.y_m / 0.05))});
    };
    for (double x = -3.5; x < 3.5; x += 0.05) {
        EXPECT_EQ(value(x, 0.0), -30) << x;
        EXPECT_EQ(value(x, -0.5), -30) << x;
    }
    EXPECT_GT(occupied_cells(map.grid), 100U);
}

TEST(MapEdit, ThePointCloudHasEveryPoint) {
    const ddtool::test::TemporaryFolder folder;
    write_ply(folder / "points.ply", small_map());
    const std::string file = read_file(folder / "points.ply");
    std::size_t points = 0;
    for (const MapNode& node : small_map().nodes) {
        points += node.scan.points.size();
    }
    const std::string end = "end_header\n";
    EXPECT_NE(file.find("element vertex " + std::to_string(points) + "\n"), std::string::npos);
    EXPECT_EQ(file.size() - file.find(end) - end.size(), 28 * points);
}

}  // namespace
}  // namespace ddtool::maps
