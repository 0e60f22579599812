#include "graph/solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "graph/marginals.hpp"
#include "known_graphs.hpp"

namespace ddtool::graph {
namespace {

using namespace test;

/// Two steps of a metre with variance 1 and a measurement of 2.3 m over both, with variance 1. With equal steps d by
/// symmetry, (d - 1) + (2 d - 2.3) = 0 gives d = 1.1. The information about both steps is [2 1; 1 2], its inverse
/// [2 -1; -1 2] / 3, so that x of node 1 and x of node 2 both have the variance 2/3.
TEST(GraphSolver, SolvesWhatCanBeSolvedByHand) {
    PoseGraph graph = straight_drive(3, 1.0);
    graph.matches.push_back({.from = 0, .to = 2, .measured = {2.3, 0.0, 0.0}});
    graph.matches.back().information(0, 0) = 1.0;
    const Solution solution = minimise(graph);
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(graph.poses[1].x_m, 1.1, 1e-9);
    EXPECT_NEAR(graph.poses[2].x_m, 2.2, 1e-9);
    EXPECT_NEAR(solution.cost, 0.5 * 3 * 0.01, 1e-9);
    const Marginals marginals(graph);
    EXPECT_NEAR(marginals.of_nodes()[1](0, 0), 2.0 / 3.0, 1e-9);
    EXPECT_NEAR(marginals.of_nodes()[2](0, 0), 2.0 / 3.0, 1e-9);
}

TEST(GraphSolver, ALoopSpreadsItsErrorOverTheRing) {
    constexpr std::size_t count = 40;
    PoseGraph graph = ring_drive(count, 10.0, 2e-3);
    const double open_m = distance_m(graph.poses[count], {});
    graph.loops.push_back(sure_edge(0, count, {}));
    minimise(graph);
    EXPECT_GT(open_m, 0.5);
    EXPECT_LT(distance_m(graph.poses[count], {}), 0.01);
    double largest = 0.0;
    double sum = 0.0;
    for (std::size_t node = 1; node <= count; ++node) {
        const Pose2 step = between(graph.poses[node - 1], graph.poses[node]);
        const double turned = std::abs(wrap_angle(step.theta_rad - graph.odometry[node - 1].motion.theta_rad));
        largest = std::max(largest, turned);
        sum += turned;
    }
    EXPECT_NEAR(sum, count * 2e-3, 0.01);
    EXPECT_LT(largest, 3.0 * sum / count) << "one step takes the error of all";
}

TEST(GraphSolver, AnEdgeLeavesAlongItsLostDirectionAsItWas) {
    PoseGraph graph = straight_drive(10);
    const Pose2 before = graph.poses.back();
    graph.loops.push_back(sure_edge(0, 9, {5.0, 0.4, 0.05}));
    graph.loops.back().information(0, 0) = 0.0;
    // The edge's frame is that of its end, turned by 0.05 against the corridor.
    const double c = std::cos(0.05);
    const double s = std::sin(0.05);
    Eigen::Matrix3d to_end = Eigen::Matrix3d::Identity();
    to_end.topLeftCorner<2, 2>() << c, s, -s, c;
    graph.loops.back().information = to_end * graph.loops.back().information * to_end.transpose();
    minimise(graph);
    EXPECT_NEAR(graph.poses.back().x_m, before.x_m, 0.02);
    EXPECT_NEAR(graph.poses.back().y_m, 0.4, 0.02);
    EXPECT_NEAR(graph.poses.back().theta_rad, 0.05, 0.01);
}

/// The scans tell the motion on the first half of the way, where the odometry is 2 % short; what that says of its scale
/// must reach the second half.
TEST(GraphSolver, ScaleLearntHereHelpsThere) {
    constexpr std::size_t count = 41;
    PoseGraph graph = straight_drive(count, 0.01);
    for (OdometryEdge& edge : graph.odometry) {
        edge.motion.x_m = 1.0 / 1.02;
    }
    for (std::size_t node = 1; node <= count / 2; ++node) {
        graph.matches.push_back(sure_edge(node - 1, node, {1.0, 0.0, 0.0}));
    }
    PoseGraph held = graph;
    graph.calibration.scale_sd = 0.02;
    minimise(graph);
    minimise(held);
    EXPECT_NEAR(graph.calibration.scale, 1.02, 0.003);
    EXPECT_NEAR(graph.poses.back().x_m, 40.0, 0.06);
    EXPECT_LT(held.poses.back().x_m, 39.7);
}

/// The matches make every metre a centimetre too long, which a loop edge at the end shows.
TEST(GraphSolver, StretchOfTheMatchesIsFound) {
    constexpr std::size_t count = 41;
    PoseGraph graph = straight_drive(count, 0.1);
    for (std::size_t node = 1; node < count; ++node) {
        graph.matches.push_back(sure_edge(node - 1, node, {1.01, 0.0, 0.0}));
    }
    graph.loops.push_back(sure_edge(0, count - 1, {40.0, 0.0, 0.0}));
    PoseGraph held = graph;
    graph.match_stretch.sd = 0.02;
    minimise(graph);
    minimise(held);
    EXPECT_NEAR(graph.match_stretch.value, -0.01, 0.001);
    EXPECT_EQ(held.match_stretch.value, 0.0);
    const auto of_middle = [](const PoseGraph& of) { return Marginals(of).of_nodes()[count / 2](0, 0); };
    EXPECT_GT(of_middle(graph), of_middle(held));
}

TEST(GraphSolver, BiasOfTheGyroIsFound) {
    constexpr std::size_t count = 40;
    PoseGraph graph = ring_drive(count, 10.0, 5e-4);
    graph.calibration.bias_sd_rad_per_s = 1e-3;
    for (OdometryEdge& edge : graph.odometry) {
        edge.sigmas.z() = 1e-3;
    }
    graph.loops.push_back(sure_edge(0, count, {}));
    graph.loops.push_back(sure_edge(count, 2 * count, {}));
    minimise(graph);
    EXPECT_NEAR(graph.calibration.bias_rad_per_s, -5e-4, 1e-4);
}

TEST(GraphSolver, MarginalsAreTheBlocksOfTheInverse) {
    PoseGraph graph = ring_drive(15, 5.0, 1e-3);
    graph.calibration.scale_sd = 0.02;
    graph.calibration.bias_sd_rad_per_s = 1e-3;
    graph.match_stretch.sd = 2e-3;
    graph.matches.push_back(sure_edge(2, 5, between(on_ring(2, 15, 5.0), on_ring(5, 15, 5.0))));
    graph.loops.push_back(sure_edge(0, 15, {}));
    graph.loops.push_back(sure_edge(4, 21, between(on_ring(4, 15, 5.0), on_ring(21, 15, 5.0))));
    minimise(graph);
    const Eigen::MatrixXd lower = normal_equations(graph).system;
    const Eigen::MatrixXd inverse = Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>()).inverse();
    const Marginals marginals(graph);
    for (std::size_t node = 1; node < graph.poses.size(); ++node) {
        const Eigen::Index at = Unknowns::of_node(node);
        EXPECT_TRUE(marginals.of_nodes()[node].isApprox(inverse.block<3, 3>(at, at), 1e-6)) << node;
        EXPECT_TRUE(marginals.with_node(node).isApprox(inverse.middleCols<3>(at), 1e-6)) << node;
    }
    EXPECT_EQ(marginals.of_nodes()[0], Eigen::Matrix3d::Zero());
}

TEST(GraphSolver, DerivativesAreThoseOfTheError) {
    const Pose2 from{1.0, -2.0, 0.7};
    const Pose2 to{2.5, -1.0, -2.0};
    const Pose2 measured{1.4, 0.2, -2.5};
    for (const bool in_target_frame : {false, true}) {
        const EdgeError at = edge_error(from, to, measured, in_target_frame);
        constexpr double small = 1e-6;
        for (int unknown = 0; unknown < 3; ++unknown) {
            const auto moved = [&](Pose2 pose) {
                (unknown == 0 ? pose.x_m : unknown == 1 ? pose.y_m : pose.theta_rad) += small;
                return pose;
            };
            const Eigen::Vector3d by_from =
                (edge_error(moved(from), to, measured, in_target_frame).error - at.error) / small;
            const Eigen::Vector3d by_to =
                (edge_error(from, moved(to), measured, in_target_frame).error - at.error) / small;
            EXPECT_TRUE(by_from.isApprox(at.by_from.col(unknown), 1e-4));
            EXPECT_TRUE(by_to.isApprox(at.by_to.col(unknown), 1e-4));
        }
    }
}

TEST(GraphSolver, TakesGraphsWithNothingToSolve) {
    PoseGraph empty;
    EXPECT_TRUE(minimise(empty).iterations >= 0);
    PoseGraph one = held_calibration();
    one.poses.push_back({1.0, 2.0, 3.0});
    EXPECT_TRUE(minimise(one).converged);
    EXPECT_EQ(Marginals(one).of_nodes().size(), 1U);
}

}  // namespace
}  // namespace ddtool::graph
