#include "ddtool/filter/scan_matcher.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>

#include "ddtool/base/random.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "room_scans.hpp"

namespace ddtool {
namespace {

/// A power of two, so that moving by whole cells causes no rounding errors.
constexpr double cell_m = 0.0625;
constexpr PosePrior loose{1.0, 1.0, 1.0};

OccupancyGrid grid_with(const ScanPoints& points, const Pose2& pose) {
    OccupancySettings settings;
    settings.cell_size_m = cell_m;
    OccupancyGrid grid(settings);
    ScanInserter().insert(grid, points, pose);
    return grid;
}

ScanMatcher matcher() { return {ScanMatcherSettings{}, cell_m}; }

/// A view of the furnished room, and the grid that was made from the same scan.
struct View {
    Pose2 pose{0.21, -0.33, 0.4};
    ScanPoints points = exact_points(furnished_room(), pose);
    OccupancyGrid grid = grid_with(points, pose);
    MatchPoints match_points{points, cell_m};
};

TEST(ScanMatcher, ScoresOneWhereTheScanWasTaken) {
    const View view;
    const double score = matcher().score(view.grid, view.match_points, view.pose);
    EXPECT_GT(score, 0.99);
    EXPECT_LE(score, 1.0 + 1e-6);
    EXPECT_LT(matcher().score(view.grid, view.match_points, view.pose * Pose2{0.05, 0.05, 0.02}), 0.9 * score);
}

TEST(ScanMatcher, FindsTheWayBackFromRandomDisplacements) {
    RandomStream random{1};
    const View view;
    for (int i = 0; i < 50; ++i) {
        const Pose2 start =
            view.pose * Pose2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15)};
        const ScanMatch match = matcher().match(view.grid, view.match_points, start, loose);
        EXPECT_LT(distance_m(match.pose, view.pose), 0.003) << i;
        EXPECT_NEAR(match.pose.theta_rad, view.pose.theta_rad, 0.001) << i;
        EXPECT_GT(match.score, 0.95) << i;
    }
}

TEST(ScanMatcher, FindsThePoseOfAnotherView) {
    RandomStream random{2};
    const View view;
    for (int i = 0; i < 10; ++i) {
        const Pose2 truth = view.pose * Pose2{0.3, -0.1, random.uniform(-0.5, 0.5)};
        const MatchPoints points(exact_points(furnished_room(), truth), cell_m);
        const Pose2 start = truth * Pose2{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.05};
        const ScanMatch match = matcher().match(view.grid, points, start, loose);
        EXPECT_LT(distance_m(match.pose, truth), 0.015) << i;
        EXPECT_NEAR(match.pose.theta_rad, truth.theta_rad, 0.005) << i;
    }
}

TEST(ScanMatcher, MatchesFromTheStartThatFitsBest) {
    const View view;
    const Pose2 far = view.pose * Pose2{1.5, 1.2, 0.9};
    const std::vector<Pose2> starts{far, view.pose * Pose2{0.02, 0.01, 0.01}, far * Pose2{0.1, 0.0, 0.1}};
    const ScanMatch direct = matcher().match_directly(view.grid, view.match_points, far, loose);
    EXPECT_TRUE(matcher().is_doubtful(direct));
    const ScanMatch match = matcher().match_from(starts, direct, view.grid, view.match_points, far, loose);
    EXPECT_LT(distance_m(match.pose, view.pose), 0.015);
    EXPECT_FALSE(matcher().is_doubtful(match));
    // A match that is better than what the starts lead to stays.
    EXPECT_EQ(matcher().match_from({&far, 1}, match, view.grid, view.match_points, far, loose).pose, match.pose);
}

/// Off in place and heading at once, headings tried where the robot is not may all look wrong.
TEST(ScanMatcher, AllPairsOfPlaceAndHeadingFindWhatOneAfterTheOtherMisses) {
    RandomStream random{3};
    const View view;
    const auto found_from = [&](const Pose2& start, SearchOrder order) {
        const Pose2 found = matcher().search(view.grid, view.match_points, start, order);
        return matcher().match_directly(view.grid, view.match_points, found, loose).score > 0.9;
    };
    int missed = 0;
    for (int i = 0; i < 40; ++i) {
        const Pose2 start =
            view.pose * Pose2{random.uniform(-0.55, 0.55), random.uniform(-0.55, 0.55), random.uniform(-0.33, 0.33)};
        EXPECT_TRUE(found_from(start, SearchOrder::all_pairs)) << i;
        missed += found_from(start, SearchOrder::headings_first) ? 0 : 1;
    }
    EXPECT_GT(missed, 0);
}

TEST(ScanMatcher, LeavesTheWayAlongACorridorToThePrior) {
    const sim::World corridor = room(80.0, 2.0);
    const Pose2 mapped_from{0.3, 0.1, 0.0};
    const Pose2 pose{0.8, -0.1, 0.0};
    const OccupancyGrid grid = grid_with(exact_points(corridor, mapped_from, 720, 12.0), mapped_from);
    const ScanPoints points = exact_points(corridor, pose, 720, 12.0);
    const Pose2 start{pose.x_m + 0.1, pose.y_m - 0.08, 0.03};
    const ScanMatch match = matcher().match(grid, {points, cell_m}, start, {0.1, 0.1, 0.1});
    EXPECT_NEAR(match.pose.x_m, start.x_m, 0.003);
    EXPECT_NEAR(match.pose.y_m, pose.y_m, 0.003);
    EXPECT_NEAR(match.pose.theta_rad, 0.0, 0.001);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(match.information.topLeftCorner<2, 2>());
    EXPECT_LT(solver.eigenvalues()(0), 1e-3 * solver.eigenvalues()(1));
    EXPECT_NEAR(std::abs(solver.eigenvectors()(0, 0)), 1.0, 0.01);
}

/// The end of the map is seen along a wall by one scan after the other, so that the nearest occupied point lies behind
/// the end point. Where the scan takes its surfaces in a wrong direction, as beside an edge, that must not pull the
/// robot along.
TEST(ScanMatcher, MeasuresAcrossTheLinesOfTheMap) {
    const sim::World corridor = room(80.0, 2.0);
    const Pose2 mapped_from{0.3, 0.1, 0.0};
    const Pose2 pose{0.8, -0.1, 0.0};
    OccupancyGrid grid = grid_with(exact_points(corridor, mapped_from, 2880, 3.0), mapped_from);
    for (int scan = 0; scan < 3; ++scan) {
        ScanInserter().insert(grid, exact_points(corridor, mapped_from, 2880, 3.0), mapped_from);
    }
    MatchPoints points(exact_points(corridor, pose, 2880, 3.0), cell_m);
    constexpr float tilt_rad = 0.4F;
    for (std::size_t i = 0; i < points.beams; ++i) {
        const float nx = points.normal_x[i];
        const float ny = points.normal_y[i];
        points.normal_x[i] = std::cos(tilt_rad) * nx - std::sin(tilt_rad) * ny;
        points.normal_y[i] = std::sin(tilt_rad) * nx + std::cos(tilt_rad) * ny;
    }
    const ScanMatch match = matcher().match(grid, points, pose, {0.1, 0.1, 0.1});
    EXPECT_NEAR(match.pose.x_m, pose.x_m, 0.01);
    EXPECT_NEAR(match.pose.y_m, pose.y_m, 0.005);
    const Eigen::Matrix2d position = match.information.topLeftCorner<2, 2>();
    EXPECT_LT(position(0, 0), 0.02 * position(1, 1));
}

TEST(ScanMatcher, InformationOfARoomConstrainsEverything) {
    const View view;
    const ScanMatch match = matcher().match(view.grid, view.match_points, view.pose, loose);
    EXPECT_TRUE(match.information.isApprox(match.information.transpose()));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(match.information);
    EXPECT_GT(solver.eigenvalues()(0), 0.02 * solver.eigenvalues()(2));
}

TEST(ScanMatcher, SaysTheSameOfAWorldMovedByWholeCells) {
    const View view;
    const Pose2 probe = view.pose * Pose2{0.04, -0.03, 0.02};
    const double log_likelihood = matcher().evaluate(view.grid, view.match_points, probe).log_likelihood;
    for (const int cells : {1, 32, -77, 4096}) {
        const Pose2 motion{cell_m * cells, -2.0 * cell_m * cells, 0.0};
        const OccupancyGrid moved = grid_with(view.points, motion * view.pose);
        EXPECT_NEAR(matcher().evaluate(moved, view.match_points, motion * probe).log_likelihood, log_likelihood,
                    1e-3 * std::abs(log_likelihood))
            << cells;
    }
}

TEST(ScanMatcher, SaysTheSameOfAWorldTurnedByQuarters) {
    const View view;
    const Pose2 probe = view.pose * Pose2{0.04, -0.03, 0.02};
    const double log_likelihood = matcher().evaluate(view.grid, view.match_points, probe).log_likelihood;
    for (const double quarters : {1.0, 2.0, -1.0}) {
        const Pose2 motion{0.0, 0.0, quarters * std::numbers::pi / 2.0};
        const OccupancyGrid turned = grid_with(view.points, motion * view.pose);
        EXPECT_NEAR(matcher().evaluate(turned, view.match_points, motion * probe).log_likelihood, log_likelihood,
                    0.01 * std::abs(log_likelihood))
            << quarters;
    }
}

/// Somebody who stands in every fourth beam is not in the map, and must not make the lidar look noisy.
TEST(ScanMatcher, MeasuresHowFarBeamsLieFromTheirSurfaces) {
    const View view;
    const Pose2 beside = view.pose * Pose2{0.04, 0.0, 0.0};
    const auto misfit_m = [](const ScanMatch& match) { return std::sqrt(match.misfit_m2); };
    EXPECT_LT(misfit_m(matcher().evaluate(view.grid, view.match_points, view.pose)), 0.004);
    const double all_m = misfit_m(matcher().evaluate(view.grid, view.match_points, beside));
    EXPECT_GT(all_m, 0.01);
    EXPECT_LT(all_m, 0.04);
    ScanPoints hidden = view.points;
    for (std::size_t beam = 0; beam < hidden.size(); beam += 4) {
        hidden.x_m[beam] *= 0.5F;
        hidden.y_m[beam] *= 0.5F;
    }
    EXPECT_NEAR(misfit_m(matcher().evaluate(view.grid, MatchPoints(hidden, cell_m), beside)), all_m, 0.2 * all_m);
}

TEST(ScanMatcher, LikelihoodFallsWithTheDistance) {
    const View view;
    double before = 1.0;
    for (const double off_m : {0.0, 0.02, 0.05, 0.1, 0.2}) {
        const double value =
            matcher().evaluate(view.grid, view.match_points, view.pose * Pose2{off_m, off_m, 0.0}).log_likelihood;
        EXPECT_LE(value, 0.0);
        EXPECT_LT(value, before) << off_m;
        before = value;
    }
}

/// The points on the left or the right side of the robot, each group without the other.
ScanPoints side_of(const ScanPoints& all, bool left) {
    ScanPoints side;
    side.origin_m = all.origin_m;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (left ? all.y_m[i] > 1.0F : all.y_m[i] < -1.0F) {
            side.x_m.push_back(all.x_m[i]);
            side.y_m.push_back(all.y_m[i]);
            side.normal_x.push_back(all.normal_x[i]);
            side.normal_y.push_back(all.normal_y[i]);
            side.along_weight.push_back(all.along_weight[i]);
            side.order.push_back(all.order[i]);
        }
    }
    return side;
}

ScanPoints joined(ScanPoints a, const ScanPoints& b) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(a.x_m, b.x_m);
    append(a.y_m, b.y_m);
    append(a.normal_x, b.normal_x);
    append(a.normal_y, b.normal_y);
    append(a.along_weight, b.along_weight);
    append(a.order, b.order);
    return a;
}

TEST(ScanMatcher, BeamsIntoUnknownGroundCountAsTheMeanOfTheOthers) {
    const Pose2 pose{0.0, 0.0, 0.0};
    const ScanPoints all = exact_points(furnished_room(), pose);
    const ScanPoints left = side_of(all, true);
    const ScanPoints right = side_of(all, false);
    ASSERT_GT(right.size(), 50U);
    const OccupancyGrid grid = grid_with(left, pose);
    const Pose2 probe{0.03, -0.02, 0.01};
    const double of_left = matcher().evaluate(grid, {left, cell_m}, probe).log_likelihood;
    const double of_both = matcher().evaluate(grid, {joined(left, right), cell_m}, probe).log_likelihood;
    EXPECT_LT(of_left, -0.1);
    EXPECT_NEAR(of_both / static_cast<double>(left.size() + right.size()), of_left / static_cast<double>(left.size()),
                1e-3 * std::abs(of_left / static_cast<double>(left.size())));
}

TEST(ScanMatcher, WithoutBeamsKeepsThePrediction) {
    const View view;
    const MatchPoints none(ScanPoints{}, cell_m);
    const ScanMatch match = matcher().match(view.grid, none, {1.0, 2.0, 3.0}, loose);
    EXPECT_EQ(match.pose, (Pose2{1.0, 2.0, 3.0}));
    EXPECT_EQ(match.score, 0.0);
    EXPECT_TRUE(match.information.isZero());
    EXPECT_EQ(matcher().evaluate(view.grid, none, {}).log_likelihood, 0.0);
}

TEST(ScanMatcher, InAnEmptyGridKeepsThePrediction) {
    const View view;
    const OccupancyGrid empty{OccupancySettings{}};
    const ScanMatch match = matcher().match(empty, view.match_points, view.pose, loose);
    EXPECT_LT(distance_m(match.pose, view.pose), 1e-12);
    EXPECT_EQ(match.score, 0.0);
}

TEST(ScanMatcher, DoesNotDependOnTheScansBefore) {
    const View view;
    const Pose2 start = view.pose * Pose2{0.1, -0.1, 0.05};
    ScanMatcher used = matcher();
    used.match(view.grid, {exact_points(room(60.0, 2.0), {}, 1'500), cell_m}, {}, loose);
    EXPECT_EQ(used.match(view.grid, view.match_points, start, loose).pose,
              matcher().match(view.grid, view.match_points, start, loose).pose);
}

}  // namespace
}  // namespace ddtool
