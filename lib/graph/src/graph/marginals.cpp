#include "graph/marginals.hpp"

#include <algorithm>
#include <limits>

#include "ddtool/base/error.hpp"

namespace ddtool::graph {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// The entry (row, column) of a lower triangle whose columns are sorted; row >= column. Zero where it has none.
double entry(const Sparse& lower, Eigen::Index row, Eigen::Index column) {
    const int* rows = lower.innerIndexPtr();
    const int* begin = rows + lower.outerIndexPtr()[column];
    const int* end = rows + lower.outerIndexPtr()[column + 1];
    const int* found = std::lower_bound(begin, end, static_cast<int>(row));
    return found != end && *found == row ? lower.valuePtr()[found - rows] : 0.0;
}

double symmetric_entry(const Sparse& lower, Eigen::Index a, Eigen::Index b) {
    return a >= b ? entry(lower, a, b) : entry(lower, b, a);
}

/// The inverse Z of L D L' on the pattern of L and its diagonal, from the last column to the first:
///     Z_ij = [i = j] / D_j - sum over k > j of Z_ik L_kj.
/// All Z_ik that this needs are on the pattern.
Sparse inverse_on_pattern(const Sparse& unit_lower, const Eigen::VectorXd& diagonal) {
    const Eigen::Index size = diagonal.size();
    std::vector<Eigen::Triplet<double>> pattern;
    for (Eigen::Index column = 0; column < size; ++column) {
        pattern.emplace_back(column, column, 0.0);
        for (Sparse::InnerIterator it(unit_lower, column); it; ++it) {
            if (it.row() > column) {
                pattern.emplace_back(it.row(), column, 0.0);
            }
        }
    }
    Sparse inverse(size, size);
    inverse.setFromTriplets(pattern.begin(), pattern.end());
    std::vector<std::pair<Eigen::Index, double>> below;
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> place_of(static_cast<std::size_t>(size), none);  // of a row in `below`
    std::vector<double> sums;
    for (Eigen::Index column = size - 1; column >= 0; --column) {
        below.clear();
        for (Sparse::InnerIterator it(unit_lower, column); it; ++it) {
            if (it.row() > column) {
                place_of[static_cast<std::size_t>(it.row())] = below.size();
                below.emplace_back(it.row(), it.value());
            }
        }
        // Each entry of the columns k below stands for two of the symmetric matrix.
        sums.assign(below.size(), 0.0);
        for (std::size_t k = 0; k < below.size(); ++k) {
            for (Sparse::InnerIterator it(inverse, below[k].first); it; ++it) {
                const std::size_t i = place_of[static_cast<std::size_t>(it.row())];
                if (i == none) {
                    continue;
                }
                sums[i] += it.value() * below[k].second;
                if (i != k) {
                    sums[k] += it.value() * below[i].second;
                }
            }
        }
        double* values = inverse.valuePtr() + inverse.outerIndexPtr()[column];
        values[0] = 1.0 / diagonal(column);
        for (std::size_t i = 0; i < below.size(); ++i) {
            values[i + 1] = -sums[i];  // after the diagonal, in the order of `below`
            values[0] += sums[i] * below[i].second;
            place_of[static_cast<std::size_t>(below[i].first)] = none;
        }
    }
    return inverse;
}

}  // namespace

Marginals::Marginals(const PoseGraph& graph) : nodes_(graph.poses.size()) {
    if (graph.poses.size() < 2) {
        return;
    }
    factors_.compute(normal_equations(graph).system);
    if (factors_.info() != Eigen::Success) {
        throw Error("the pose graph leaves a pose undetermined");
    }
}

const std::vector<Eigen::Matrix3d>& Marginals::of_nodes() const {
    if (of_nodes_.empty()) {
        select_inverse();
    }
    return of_nodes_;
}

void Marginals::select_inverse() const {
    of_nodes_.assign(nodes_, Eigen::Matrix3d::Zero());
    if (nodes_ < 2) {
        return;
    }
    const Sparse lower = factors_.matrixL();
    const Sparse inverse = inverse_on_pattern(lower, factors_.vectorD());
    const auto& order = factors_.permutationP().indices();
    for (std::size_t node = 1; node < of_nodes_.size(); ++node) {
        const Eigen::Index first = Unknowns::of_node(node);
        for (Eigen::Index i = 0; i < 3; ++i) {
            for (Eigen::Index j = 0; j < 3; ++j) {
                of_nodes_[node](i, j) = symmetric_entry(inverse, order(first + i), order(first + j));
            }
        }
    }
}

Eigen::MatrixXd Marginals::with_node(std::size_t node) const {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(factors_.rows(), 3);
    if (node == 0) {
        return columns;
    }
    columns.middleRows<3>(Unknowns::of_node(node)) = Eigen::Matrix3d::Identity();
    return factors_.solve(columns);
}

Eigen::Matrix3d Marginals::relative(const PoseGraph& graph, std::size_t a, std::size_t b,
                                    const Eigen::MatrixXd& with_b) const {
    const EdgeError at = edge_error(graph.poses[a], graph.poses[b], {}, false);
    Eigen::Matrix3d covariance = at.by_from * of_nodes()[a] * at.by_from.transpose();
    covariance += at.by_to * of_nodes()[b] * at.by_to.transpose();
    if (a != 0) {
        const Eigen::Matrix3d cross = at.by_from * with_b.middleRows<3>(Unknowns::of_node(a)) * at.by_to.transpose();
        covariance += cross + cross.transpose();
    }
    return 0.5 * (covariance + covariance.transpose());
}

}  // namespace ddtool::graph
