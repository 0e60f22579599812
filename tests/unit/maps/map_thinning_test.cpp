#include "maps/map_thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_map.hpp"

namespace ddtool::maps {
namespace {

/// The small map, and the same drive so many times more.
SavedMap driven_again(std::size_t times) {
    SavedMap map = test::small_map();
    map.edges = edges_or_odometry(map);
    const std::vector<MapNode> once = map.nodes;
    const std::vector<MapEdge> edges = map.edges;
    for (std::uint32_t drive = 1; drive <= times; ++drive) {
        for (MapEdge edge : edges) {
            edge.edge.from += map.nodes.size();
            edge.edge.to += map.nodes.size();
            map.edges.push_back(edge);
        }
        map.drives.push_back(map.drives.front());
        for (MapNode node : once) {
            node.drive = drive;
            map.nodes.push_back(std::move(node));
        }
    }
    return map;
}

TEST(MapThinning, ADriveThatLaterOnesCoverGoesAway) {
    SavedMap map = driven_again(3);
    const std::size_t once = test::small_map().nodes.size();
    const std::size_t dropped = thin(map, 1);
    EXPECT_EQ(dropped, 3 * once);
    EXPECT_EQ(map.nodes.size(), once);
    EXPECT_EQ(map.drives.size(), 1U);
    EXPECT_EQ(map.nodes.front().drive, 0U);
    EXPECT_EQ(map.edges.size(), once - 1);
}

TEST(MapThinning, WhatIsNotCoveredStays) {
    SavedMap map = driven_again(1);
    EXPECT_EQ(thin(map, 1000), 0U);
    SavedMap moved = driven_again(1);
    const std::size_t once = test::small_map().nodes.size();
    for (std::size_t node = once; node < moved.nodes.size(); ++node) {
        moved.nodes[node].pose = Pose2{100.0, 0.0, 0.0} * moved.nodes[node].pose;
    }
    EXPECT_LT(thin(moved, 1), once);  // its own later scans cover some
    EXPECT_EQ(moved.drives.size(), 2U);
}

TEST(MapThinning, TheLatestDriveStaysWhole) {
    SavedMap map = test::small_map();
    EXPECT_EQ(thin(map, 1), 0U);
}

/// A chain of which the middle is dropped is bridged by what its edges say in succession.
TEST(MapThinning, EdgesLeadOverWhatIsDropped) {
    SavedMap map = driven_again(1);
    const std::size_t once = test::small_map().nodes.size();
    // The first and the last scan of the first drive look at what nobody else sees.
    map.nodes[0].pose = Pose2{100.0, 0.0, 0.0} * map.nodes[0].pose;
    map.nodes[once - 1].pose = Pose2{-100.0, 0.0, 0.0} * map.nodes[once - 1].pose;
    const auto edge_from = [&](std::size_t from) {
        return std::ranges::find_if(map.edges, [&](const MapEdge& edge) { return edge.edge.from == from; })->edge;
    };
    Pose2 whole;
    Eigen::Vector3d variances = Eigen::Vector3d::Zero();
    for (std::size_t node = 0; node + 1 < once; ++node) {
        whole = whole * edge_from(node).measured;
        variances += Eigen::Matrix3d(edge_from(node).information.inverse()).diagonal();
    }
    EXPECT_EQ(thin(map, 1), once - 2);
    const graph::RelativeEdge bridge = edge_from(0);
    EXPECT_EQ(bridge.to, 1U);
    EXPECT_LT(distance_m(bridge.measured, whole), 1e-9);
    const Eigen::Matrix3d covariance = bridge.information.inverse();
    EXPECT_NEAR(covariance(2, 2), variances(2), 1e-9);
    EXPECT_GE(covariance(0, 0) + covariance(1, 1), variances(0) + variances(1) - 1e-9);
}

}  // namespace
}  // namespace ddtool::maps
