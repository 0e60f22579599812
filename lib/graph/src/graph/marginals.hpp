#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <vector>

#include "graph/pose_graph.hpp"
#include "graph/solver.hpp"

namespace ddtool::graph {

/// Covariances of a solved graph to first order: blocks of the inverse of its normal equations. Node 0 has none. It
/// holds for the graph as it was when this was made. For one thread, since what is asked for is worked out then.
class Marginals {
public:
    /// Throws Error if the graph leaves a node undetermined.
    explicit Marginals(const PoseGraph& graph);

    /// Of every node's pose (x, y, theta in the world), computed on the pattern of the factor alone (Takahashi, Fagan,
    /// Chin 1973; Erisman, Tinney 1975).
    [[nodiscard]] const std::vector<Eigen::Matrix3d>& of_nodes() const;
    /// The covariance of every unknown with (x, y, theta) of the node; column by column of Unknowns. Zero for node 0.
    [[nodiscard]] Eigen::MatrixXd with_node(std::size_t node) const;
    /// The covariance of every unknown with each row of `jacobian`, one column for each row.
    [[nodiscard]] Eigen::MatrixXd with(const Eigen::MatrixXd& jacobian_transposed) const {
        return factors_.solve(jacobian_transposed);
    }
    /// Of the pose of `b` seen from `a` (x, y, theta, in the frame of `a`). `with_b` is with_node(b).
    [[nodiscard]] Eigen::Matrix3d relative(const PoseGraph& graph, std::size_t a, std::size_t b,
                                           const Eigen::MatrixXd& with_b) const;

private:
    void select_inverse() const;

    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
    std::size_t nodes_;
    mutable std::vector<Eigen::Matrix3d> of_nodes_;  ///< empty until it is asked for
};

}  // namespace ddtool::graph
