#include "graph/g2o_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "graph/solver.hpp"
#include "known_graphs.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::graph {
namespace {

using namespace test;

TEST(G2oFile, ReadBackItIsTheSameProblem) {
    const ddtool::test::TemporaryFolder folder;
    PoseGraph graph = ring_drive(20, 8.0, 1e-3);
    graph.loops.push_back(sure_edge(0, 20, {0.05, 0.0, 0.0}));
    graph.loops.push_back(sure_edge(3, 25, {9.0, 9.0, 0.0}));
    graph.loops.back().weight = 0.0;
    minimise(graph);
    write_g2o(folder / "graph.g2o", graph);
    PoseGraph read = read_g2o(folder / "graph.g2o");
    ASSERT_EQ(read.poses.size(), graph.poses.size());
    EXPECT_EQ(read.matches.size(), graph.odometry.size() + 1) << "a loop of weight 0 is no edge";
    EXPECT_NEAR(normal_equations(read).cost, normal_equations(graph).cost, 1e-6 * normal_equations(graph).cost);
    read.poses.back() = read.poses.back() * Pose2{0.2, 0.1, 0.1};
    minimise(read);
    for (std::size_t node = 0; node < graph.poses.size(); ++node) {
        EXPECT_LT(distance_m(read.poses[node], graph.poses[node]), 1e-5);
    }
}

TEST(G2oFile, NamesFileAndLineOfWhatItCannotRead) {
    const ddtool::test::TemporaryFolder folder;
    const auto error_of = [&](const std::string& content) {
        std::ofstream(folder / "bad.g2o") << content;
        return ddtool::test::thrown_text([&] { read_g2o(folder / "bad.g2o"); });
    };
    EXPECT_NE(error_of("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 2 0 0 0\n").find("bad.g2o, line 2: expected VERTEX_SE2 1"),
              std::string::npos);
    EXPECT_NE(error_of("VERTEX_SE2 0 0 0 0\nEDGE_SE2 0 0 1 2\n").find("line 2: expected EDGE_SE2"), std::string::npos);
    EXPECT_NE(error_of("EDGE_SE3 0 0 1 2\n").find("line 1: expected VERTEX_SE2, EDGE_SE2 or FIX"), std::string::npos);
    EXPECT_NE(error_of("VERTEX_SE2 0 0 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n").find("not in the file"),
              std::string::npos);
}

}  // namespace
}  // namespace ddtool::graph
