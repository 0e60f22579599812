#include "graph/solver.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "base/squared.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool::graph {
namespace {

/// Converged when no unknown moves by more than this, in metres, radians, and parts of scale or bias.
constexpr double settled = 1e-7;
constexpr double first_damping = 1e-9;
constexpr double most_damping = 1e6;

/// Adds up the terms of the normal equations, the lower triangle alone.
class Terms {
public:
    explicit Terms(Eigen::Index unknowns) : gradient_(Eigen::VectorXd::Zero(unknowns)) {
        // The whole diagonal is always there, so that damping has a place to go.
        for (Eigen::Index i = 0; i < unknowns; ++i) {
            entries_.emplace_back(i, i, 0.0);
        }
    }

    /// Of at most three unknowns, so that it needs no memory of its own.
    using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
    using Product = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

    /// A group of neighbouring unknowns that an error depends on.
    struct Block {
        Eigen::Index first;
        Jacobian jacobian;
    };

    void add(std::initializer_list<Block> blocks, const Eigen::Vector3d& error, const Eigen::Matrix3d& information) {
        cost_ += 0.5 * error.dot(information * error);
        for (const Block& row : blocks) {
            if (row.first == Unknowns::none) {
                continue;
            }
            const Product weighted = row.jacobian.transpose() * information;
            gradient_.segment(row.first, row.jacobian.cols()) += weighted * error;
            for (const Block& column : blocks) {
                if (column.first != Unknowns::none && column.first <= row.first) {
                    add_product(row.first, column.first, weighted * column.jacobian);
                }
            }
        }
    }

    void add_prior(Eigen::Index unknown, double from_mean, double sd) {
        if (unknown == Unknowns::none) {
            return;
        }
        cost_ += 0.5 * squared(from_mean / sd);
        gradient_(unknown) += from_mean / squared(sd);
        entries_.emplace_back(unknown, unknown, 1.0 / squared(sd));
    }

    [[nodiscard]] NormalEquations take() {
        NormalEquations result;
        result.system.resize(gradient_.size(), gradient_.size());
        result.system.setFromTriplets(entries_.begin(), entries_.end());
        result.gradient = std::move(gradient_);
        result.cost = cost_;
        return result;
    }

private:
    void add_product(Eigen::Index row, Eigen::Index column, const Product& product) {
        for (Eigen::Index i = 0; i < product.rows(); ++i) {
            for (Eigen::Index j = 0; j < product.cols(); ++j) {
                if (column + j <= row + i) {
                    entries_.emplace_back(row + i, column + j, product(i, j));
                }
            }
        }
    }

    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::VectorXd gradient_;
    double cost_ = 0.0;
};

void add_relative(Terms& terms, const PoseGraph& graph, const RelativeEdge& edge) {
    const EdgeError at = edge_error(graph.poses[edge.from], graph.poses[edge.to], edge.measured, true);
    terms.add({{Unknowns::of_node(edge.from), at.by_from}, {Unknowns::of_node(edge.to), at.by_to}}, at.error,
              edge.weight * edge.information);
}

void add_match(Terms& terms, const PoseGraph& graph, const RelativeEdge& match, const Unknowns& unknowns) {
    const RelativeEdge edge = stretched(match, graph.match_stretch);
    const EdgeError at = edge_error(graph.poses[edge.from], graph.poses[edge.to], edge.measured, true);
    const Eigen::Vector3d by_stretch =
        turned_about_z(-edge.measured.theta_rad) * Eigen::Vector3d(-match.measured.x_m, -match.measured.y_m, 0.0);
    terms.add({{Unknowns::of_node(edge.from), at.by_from},
               {Unknowns::of_node(edge.to), at.by_to},
               {unknowns.stretch(), by_stretch}},
              at.error, edge.weight * edge.information);
}

void add_odometry(Terms& terms, const PoseGraph& graph, const OdometryEdge& edge, const Unknowns& unknowns) {
    const Pose2 expected = calibrated(edge, graph.calibration);
    const EdgeError at = edge_error(graph.poses[edge.from], graph.poses[edge.from + 1], expected, false);
    const Eigen::Matrix3d information = edge.sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
    terms.add({{Unknowns::of_node(edge.from), at.by_from},
               {Unknowns::of_node(edge.from + 1), at.by_to},
               {unknowns.scale(), Eigen::Vector3d(-edge.motion.x_m, -edge.motion.y_m, 0.0)},
               {unknowns.bias(), Eigen::Vector3d(0.0, 0.0, -edge.duration_s)}},
              at.error, information);
}

void move_by(PoseGraph& graph, const Unknowns& unknowns, const Eigen::VectorXd& step) {
    for (std::size_t node = 1; node < graph.poses.size(); ++node) {
        const Eigen::Index at = Unknowns::of_node(node);
        Pose2& pose = graph.poses[node];
        pose = {pose.x_m + step(at), pose.y_m + step(at + 1), wrap_angle(pose.theta_rad + step(at + 2))};
    }
    if (unknowns.scale() != Unknowns::none) {
        graph.calibration.scale += step(unknowns.scale());
    }
    if (unknowns.bias() != Unknowns::none) {
        graph.calibration.bias_rad_per_s += step(unknowns.bias());
    }
    if (unknowns.stretch() != Unknowns::none) {
        graph.match_stretch.value += step(unknowns.stretch());
    }
}

}  // namespace

Unknowns::Unknowns(const PoseGraph& graph)
    : count_(graph.poses.empty() ? 0 : 3 * static_cast<Eigen::Index>(graph.poses.size() - 1)) {
    if (graph.calibration.scale_sd > 0.0) {
        scale_ = count_++;
    }
    if (graph.calibration.bias_sd_rad_per_s > 0.0) {
        bias_ = count_++;
    }
    if (graph.match_stretch.sd > 0.0) {
        stretch_ = count_++;
    }
}

NormalEquations normal_equations(const PoseGraph& graph) {
    const Unknowns unknowns(graph);
    Terms terms(unknowns.count());
    for (const OdometryEdge& edge : graph.odometry) {
        add_odometry(terms, graph, edge, unknowns);
    }
    for (const RelativeEdge& edge : graph.matches) {
        add_match(terms, graph, edge, unknowns);
    }
    for (const RelativeEdge& edge : graph.loops) {
        add_relative(terms, graph, edge);
    }
    terms.add_prior(unknowns.scale(), graph.calibration.scale - 1.0, graph.calibration.scale_sd);
    terms.add_prior(unknowns.bias(), graph.calibration.bias_rad_per_s, graph.calibration.bias_sd_rad_per_s);
    terms.add_prior(unknowns.stretch(), graph.match_stretch.value, graph.match_stretch.sd);
    return terms.take();
}

Solution minimise(PoseGraph& graph, int most_iterations) {
    const Unknowns unknowns(graph);
    NormalEquations present = normal_equations(graph);
    Solution solution{.cost = present.cost};
    if (unknowns.count() == 0) {
        solution.converged = true;
        return solution;
    }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
    factors.analyzePattern(present.system);
    double damping = first_damping;
    while (solution.iterations < most_iterations && damping <= most_damping) {
        ++solution.iterations;
        Eigen::SparseMatrix<double> damped = present.system;
        damped.diagonal() *= 1.0 + damping;
        factors.factorize(damped);
        if (factors.info() != Eigen::Success) {
            damping *= 10.0;
            continue;
        }
        const Eigen::VectorXd step = -factors.solve(present.gradient);
        PoseGraph moved = graph;
        move_by(moved, unknowns, step);
        NormalEquations next = normal_equations(moved);
        if (!(next.cost <= present.cost * (1.0 + 1e-12))) {
            damping *= 10.0;
            continue;
        }
        graph = std::move(moved);
        present = std::move(next);
        solution.cost = present.cost;
        damping = std::max(first_damping, 0.1 * damping);
        if (step.lpNorm<Eigen::Infinity>() < settled) {
            solution.converged = true;
            break;
        }
    }
    return solution;
}

}  // namespace ddtool::graph
