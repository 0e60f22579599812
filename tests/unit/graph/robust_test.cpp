#include "graph/robust.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "known_graphs.hpp"

namespace ddtool::graph {
namespace {

using namespace test;

constexpr std::size_t count = 40;
constexpr double radius_m = 10.0;

/// Ten true loops between the laps of a ring, and six false ones, each of its own.
PoseGraph ring_with_false_loops() {
    PoseGraph graph = ring_drive(count, radius_m, 1e-3);
    minimise(graph);
    for (std::size_t node = 0; node < count; node += 4) {
        graph.loops.push_back(sure_edge(node, node + count, {}));
    }
    for (std::size_t node = 1; node < 13; node += 2) {
        const double off = 1.5 + 0.1 * static_cast<double>(node);
        graph.loops.push_back(sure_edge(node, node + count, {off, node % 4 == 1 ? off : -off, 0.0}));
    }
    return graph;
}

double largest_error_m(const PoseGraph& graph) {
    double largest = 0.0;
    for (std::size_t node = 0; node < graph.poses.size(); ++node) {
        largest = std::max(largest, distance_m(graph.poses[node], true_on_ring(node, count, radius_m)));
    }
    return largest;
}

TEST(RobustGraph, ThrowsFalseLoopsOutAndKeepsTrueOnes) {
    PoseGraph graph = ring_with_false_loops();
    PoseGraph trusting = graph;
    minimise(trusting);
    minimise_robustly(graph);
    for (std::size_t loop = 0; loop < graph.loops.size(); ++loop) {
        EXPECT_NEAR(graph.loops[loop].weight, loop < 10 ? 1.0 : 0.0, 1e-6) << loop;
    }
    PoseGraph without_false = ring_with_false_loops();
    without_false.loops.resize(10);
    minimise(without_false);
    EXPECT_NEAR(largest_error_m(graph), largest_error_m(without_false), 1e-6);
    EXPECT_GT(largest_error_m(trusting), 2.0 * largest_error_m(graph));
}

TEST(RobustGraph, KeepsEverythingWhereNothingContradicts) {
    PoseGraph graph = ring_with_false_loops();
    graph.loops.resize(10);
    minimise_robustly(graph);
    EXPECT_TRUE(std::all_of(graph.loops.begin(), graph.loops.end(),
                            [](const RelativeEdge& loop) { return loop.weight == 1.0; }));
}

TEST(RobustGraph, LoopsThatContradictMostOthersAreDropped) {
    PoseGraph graph = ring_with_false_loops();
    const std::vector<RelativeEdge> loops = std::move(graph.loops);
    graph.loops.clear();
    const std::vector<Consistency> consistency = consistency_of(graph, loops);
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        EXPECT_EQ(consistency[loop].kept, loop < 10) << loop;
    }
}

TEST(RobustGraph, ALoopThatTheOdometryExcludesIsOutsideTheGate) {
    PoseGraph graph = ring_drive(count, radius_m, 0.0);
    const std::vector<RelativeEdge> loops{sure_edge(0, count, {5.0, 5.0, 1.0}), sure_edge(0, count, {})};
    const std::vector<Consistency> consistency = consistency_of(graph, loops);
    EXPECT_FALSE(consistency[0].within_gate);
    EXPECT_TRUE(consistency[1].kept);
}

TEST(RobustGraph, ADirectionThatALoopDoesNotHoldContradictsNothing) {
    PoseGraph graph = straight_drive(20, 0.02);
    RelativeEdge along = sure_edge(0, 19, {9.0, 0.0, 0.0});
    EXPECT_FALSE(consistency_of(graph, std::vector{along}).front().kept);
    along.information(0, 0) = 0.0;
    EXPECT_TRUE(consistency_of(graph, std::vector{along}).front().kept);
}

}  // namespace
}  // namespace ddtool::graph
