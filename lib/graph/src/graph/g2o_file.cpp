#include "graph/g2o_file.hpp"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::graph {
namespace {

void write_edge(std::ostream& out, std::size_t from, std::size_t to, const Pose2& measured,
                const Eigen::Matrix3d& information) {
    out << "EDGE_SE2 " << from << ' ' << to << ' ' << measured.x_m << ' ' << measured.y_m << ' ' << measured.theta_rad;
    for (int row = 0; row < 3; ++row) {
        for (int column = row; column < 3; ++column) {
            out << ' ' << information(row, column);
        }
    }
    out << '\n';
}

void write_relative(std::ostream& out, const RelativeEdge& edge) {
    if (edge.weight > 0.0) {
        write_edge(out, edge.from, edge.to, edge.measured, edge.weight * edge.information);
    }
}

class G2oReader {
public:
    explicit G2oReader(std::filesystem::path file) : file_(std::move(file)) {}

    PoseGraph read() {
        graph_.calibration.scale_sd = graph_.calibration.bias_sd_rad_per_s = 0.0;
        std::istringstream lines(read_file(file_));
        std::string line;
        while (std::getline(lines, line)) {
            ++line_;
            std::istringstream words(line);
            std::string kind;
            words >> kind;
            if (kind == "VERTEX_SE2") {
                add_vertex(words);
            } else if (kind == "EDGE_SE2") {
                add_edge(words);
            } else if (!kind.empty() && kind != "FIX" && kind.front() != '#') {
                fail("expected VERTEX_SE2, EDGE_SE2 or FIX, not '" + kind + "'");
            }
        }
        for (const RelativeEdge& edge : graph_.matches) {
            if (edge.from >= graph_.poses.size() || edge.to >= graph_.poses.size()) {
                throw Error(file_.string() + ": an edge names a vertex that is not in the file");
            }
        }
        return std::move(graph_);
    }

private:
    void add_vertex(std::istringstream& words) {
        std::size_t number = 0;
        Pose2 pose;
        words >> number >> pose.x_m >> pose.y_m >> pose.theta_rad;
        if (!words || number != graph_.poses.size()) {
            fail("expected VERTEX_SE2 " + std::to_string(graph_.poses.size()) + " x y theta");
        }
        graph_.poses.push_back(pose);
    }

    void add_edge(std::istringstream& words) {
        RelativeEdge edge;
        words >> edge.from >> edge.to >> edge.measured.x_m >> edge.measured.y_m >> edge.measured.theta_rad;
        for (int row = 0; row < 3; ++row) {
            for (int column = row; column < 3; ++column) {
                words >> edge.information(row, column);
                edge.information(column, row) = edge.information(row, column);
            }
        }
        if (!words) {
            fail("expected EDGE_SE2 from to x y theta and six numbers of information");
        }
        graph_.matches.push_back(edge);
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw Error(file_.string() + ", line " + std::to_string(line_) + ": " + expected);
    }

    std::filesystem::path file_;
    std::size_t line_ = 0;
    PoseGraph graph_;
};

}  // namespace

void write_g2o(const std::filesystem::path& file, const PoseGraph& graph) {
    write_file(file, [&](std::ostream& out) {
        out << std::setprecision(12);
        for (std::size_t node = 0; node < graph.poses.size(); ++node) {
            const Pose2& pose = graph.poses[node];
            out << "VERTEX_SE2 " << node << ' ' << pose.x_m << ' ' << pose.y_m << ' ' << pose.theta_rad << '\n';
        }
        out << "FIX 0\n";
        for (const OdometryEdge& edge : graph.odometry) {
            write_relative(out, relative_edge(edge, graph.calibration));  // g2o's errors are in the frame of the end
        }
        for (const RelativeEdge& edge : graph.matches) {
            write_relative(out, stretched(edge, graph.match_stretch));
        }
        for (const RelativeEdge& edge : graph.loops) {
            write_relative(out, edge);
        }
    });
}

PoseGraph read_g2o(const std::filesystem::path& file) { return G2oReader(file).read(); }

}  // namespace ddtool::graph
