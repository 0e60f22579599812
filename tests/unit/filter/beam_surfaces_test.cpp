#include "ddtool/filter/beam_surfaces.hpp"

#include <gtest/gtest.h>

#include "ddtool/filter/scan_insertion.hpp"
#include "room_scans.hpp"

namespace ddtool {
namespace {

/// A furnished room that one scan has drawn, seen by the same scan from poses near it.
class RoomSurfaces : public testing::Test {
protected:
    static constexpr double cell_m = 0.05;

    RoomSurfaces()
        : points_(exact_points(furnished_room(), pose_)), grid_(OccupancySettings{}), match_points_(points_, cell_m) {
        ScanInserter().insert(grid_, points_, pose_);
    }

    Residuals from_nothing(const Pose2& pose, MeasuredAcross across) {
        BeamSurfaces surfaces(cell_m);
        surfaces.begin(match_points_);
        surfaces.find(grid_, match_points_, pose, across);
        return surfaces.residuals();
    }

    static void expect_same(const Residuals& a, const Residuals& b) {
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
        EXPECT_EQ(a.normal_x, b.normal_x);
        EXPECT_EQ(a.normal_y, b.normal_y);
        EXPECT_EQ(a.along_weight, b.along_weight);
        EXPECT_EQ(a.found, b.found);
        EXPECT_EQ(a.known, b.known);
    }

    Pose2 pose_{0.21, -0.33, 0.4};
    ScanPoints points_;
    OccupancyGrid grid_;
    MatchPoints match_points_;
};

/// What was looked up for the cells of the pose before must not stay where a beam has come to another cell.
TEST_F(RoomSurfaces, FromPoseToPoseAreThoseFoundFromNothing) {
    BeamSurfaces surfaces(cell_m);
    surfaces.begin(match_points_);
    for (const double step : {0.0, 0.001, 0.01, 0.08, -0.3, 0.002}) {
        const Pose2 pose = pose_ * Pose2{step, -0.5 * step, 0.2 * step};
        for (const MeasuredAcross across : {MeasuredAcross::map_lines, MeasuredAcross::scan_surfaces}) {
            surfaces.find(grid_, match_points_, pose, across);
            expect_same(surfaces.residuals(), from_nothing(pose, across));
        }
    }
    for (const double step : {0.0, 0.001, 0.01, 0.08, -0.3, 0.002}) {
        const Pose2 pose = pose_ * Pose2{step, -0.5 * step, 0.2 * step};
        surfaces.find(grid_, match_points_, pose, MeasuredAcross::map_lines);
        expect_same(surfaces.residuals(), from_nothing(pose, MeasuredAcross::map_lines));
    }
}

/// The grid has changed after the first search: a wall has come nearer.
TEST_F(RoomSurfaces, AreLookedUpAnewInAnotherGrid) {
    BeamSurfaces surfaces(cell_m);
    surfaces.begin(match_points_);
    surfaces.find(grid_, match_points_, pose_, MeasuredAcross::map_lines);
    const Residuals before = surfaces.residuals();
    ScanInserter().insert(grid_, points_, pose_ * Pose2{0.05, 0.05, 0.0});
    surfaces.begin(match_points_);
    surfaces.find(grid_, match_points_, pose_, MeasuredAcross::map_lines);
    EXPECT_NE(surfaces.residuals().x, before.x);
    expect_same(surfaces.residuals(), from_nothing(pose_, MeasuredAcross::map_lines));
}

/// The robot far from the origin, where a float would not hold a cell's number and a place in it together.
TEST_F(RoomSurfaces, AreTheSameFarFromTheOrigin) {
    const Pose2 far{pose_.x_m + 50000.0, pose_.y_m - 50000.0, pose_.theta_rad};
    const Residuals near = from_nothing(pose_, MeasuredAcross::map_lines);
    grid_ = OccupancyGrid(OccupancySettings{});
    ScanInserter().insert(grid_, points_, far);
    const Residuals there = from_nothing(far, MeasuredAcross::map_lines);
    for (std::size_t beam = 0; beam < match_points_.beams; ++beam) {
        ASSERT_NEAR(there.x[beam], near.x[beam], 0.04) << beam;
        ASSERT_NEAR(there.y[beam], near.y[beam], 0.04) << beam;
    }
}

}  // namespace
}  // namespace ddtool
