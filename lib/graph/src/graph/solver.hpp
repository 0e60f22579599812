#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>

#include "graph/pose_graph.hpp"

namespace ddtool::graph {

/// The numbers of the unknowns in the linear system: three for each node after the first, then scale, bias and stretch
/// as far as they are free.
class Unknowns {
public:
    static constexpr Eigen::Index none = -1;

    explicit Unknowns(const PoseGraph& graph);

    /// Of the node's x; y and theta follow. `none` for node 0.
    [[nodiscard]] static Eigen::Index of_node(std::size_t node) {
        return node == 0 ? none : 3 * static_cast<Eigen::Index>(node - 1);
    }
    [[nodiscard]] Eigen::Index scale() const { return scale_; }
    [[nodiscard]] Eigen::Index bias() const { return bias_; }
    [[nodiscard]] Eigen::Index stretch() const { return stretch_; }
    [[nodiscard]] Eigen::Index count() const { return count_; }

private:
    Eigen::Index scale_ = none;
    Eigen::Index bias_ = none;
    Eigen::Index stretch_ = none;
    Eigen::Index count_ = 0;
};

/// The normal equations H d = -g at the graph's present poses.
struct NormalEquations {
    Eigen::SparseMatrix<double> system;  ///< H, its lower triangle
    Eigen::VectorXd gradient;
    double cost = 0.0;  ///< half the sum of squared errors in units of their covariances
};
NormalEquations normal_equations(const PoseGraph& graph);

/// What minimise() did.
struct Solution {
    double cost = 0.0;
    int iterations = 0;
    bool converged = false;
};

/// Moves the poses, scale, bias and stretch to the least cost, by Levenberg and Marquardt's damped Gauss-Newton steps
/// with Eigen's sparse Cholesky factorisation. The same graph gives the same bytes. If a system cannot be factorised
/// even with damping, the graph stays as it was before that step.
Solution minimise(PoseGraph& graph, int most_iterations = 30);

}  // namespace ddtool::graph
