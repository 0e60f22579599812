#include "graph/robust.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/squared.hpp"
#include "graph/marginals.hpp"

namespace ddtool::graph {
namespace {

/// Squared errors below these are usual at 99.9 %: chi-square of 3 and of 6 degrees of freedom. The covariances come
/// from a linearised graph, whose errors are not independent, so a deviation counts as one and a half.
constexpr double deviation_counts = 1.5;
constexpr double most_single = 16.27 * deviation_counts * deviation_counts;
constexpr double most_pair = 22.46 * deviation_counts * deviation_counts;
/// Beyond this squared error a loop has no pull: chi-square of 3 degrees of freedom at 99 %.
constexpr double truncation = 11.34;
/// A direction that a loop does not hold counts as known to so much, so that covariances stay finite.
constexpr double unknown_variance = 1e4;
/// Loops of longer runs are compared in groups, so that memory does not grow with the square of their number.
constexpr std::size_t most_in_group = 400;

Eigen::Matrix3d covariance_of(const RelativeEdge& edge) {
    const Eigen::Matrix3d least = Eigen::Matrix3d::Identity() / unknown_variance;
    return (edge.information + least).inverse();
}

double joint_squared_error(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& errors, Eigen::Index a,
                           Eigen::Index b) {
    Eigen::Matrix<double, 6, 6> both;
    both << covariance.block<3, 3>(3 * a, 3 * a), covariance.block<3, 3>(3 * a, 3 * b),
        covariance.block<3, 3>(3 * b, 3 * a), covariance.block<3, 3>(3 * b, 3 * b);
    Eigen::Matrix<double, 6, 1> error;
    error << errors.segment<3>(3 * a), errors.segment<3>(3 * b);
    return error.dot(both.ldlt().solve(error));
}

/// The loops' errors in the graph, and their covariance: the graph's and the loops' own.
struct Innovations {
    Eigen::VectorXd errors;
    Eigen::MatrixXd covariance;
};

Innovations innovations_of(const PoseGraph& graph, const Marginals& marginals, std::span<const RelativeEdge> loops) {
    const auto rows = 3 * static_cast<Eigen::Index>(loops.size());
    const Unknowns unknowns(graph);
    Innovations result{Eigen::VectorXd::Zero(rows), Eigen::MatrixXd::Zero(rows, rows)};
    Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(unknowns.count(), rows);
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const RelativeEdge& edge = loops[loop];
        const EdgeError at = edge_error(graph.poses[edge.from], graph.poses[edge.to], edge.measured, true);
        const auto row = 3 * static_cast<Eigen::Index>(loop);
        result.errors.segment<3>(row) = at.error;
        if (edge.from != 0) {
            transposed.block<3, 3>(Unknowns::of_node(edge.from), row) = at.by_from.transpose();
        }
        transposed.block<3, 3>(Unknowns::of_node(edge.to), row) = at.by_to.transpose();
        result.covariance.block<3, 3>(row, row) = covariance_of(edge);
    }
    result.covariance += transposed.transpose() * marginals.with(transposed);
    return result;
}

std::vector<Consistency> consistency_of_group(const PoseGraph& graph, const Marginals& marginals,
                                              std::span<const RelativeEdge> loops) {
    std::vector<Consistency> result(loops.size());
    const Innovations innovations = innovations_of(graph, marginals, loops);
    std::vector<std::size_t> left;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const auto row = 3 * static_cast<Eigen::Index>(loop);
        const Eigen::Vector3d error = innovations.errors.segment<3>(row);
        const Eigen::Matrix3d covariance = innovations.covariance.block<3, 3>(row, row);
        result[loop].within_gate = result[loop].kept = error.dot(covariance.ldlt().solve(error)) <= most_single;
        if (result[loop].kept) {
            left.push_back(loop);
        }
    }
    std::vector<std::vector<bool>> apart(loops.size(), std::vector<bool>(loops.size(), false));
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (std::size_t j = i + 1; j < left.size(); ++j) {
            const bool contradict =
                joint_squared_error(innovations.covariance, innovations.errors, static_cast<Eigen::Index>(left[i]),
                                    static_cast<Eigen::Index>(left[j])) > most_pair;
            apart[left[i]][left[j]] = apart[left[j]][left[i]] = contradict;
            result[left[i]].contradicts += contradict ? 1 : 0;
            result[left[j]].contradicts += contradict ? 1 : 0;
        }
    }
    std::vector<std::size_t> contradictions(loops.size());
    std::transform(result.begin(), result.end(), contradictions.begin(),
                   [](const Consistency& loop) { return loop.contradicts; });
    while (left.size() > 1) {
        const auto worst = std::max_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
            return contradictions[a] < contradictions[b];
        });
        if (2 * contradictions[*worst] <= left.size() - 1) {
            break;
        }
        const std::size_t dropped = *worst;
        left.erase(worst);
        result[dropped].kept = false;
        for (const std::size_t other : left) {
            contradictions[other] -= apart[dropped][other] ? 1 : 0;
        }
    }
    return result;
}

}  // namespace

std::vector<Consistency> consistency_of(const PoseGraph& graph, std::span<const RelativeEdge> loops) {
    std::vector<Consistency> result;
    const Marginals marginals(graph);
    for (std::size_t first = 0; first < loops.size(); first += most_in_group) {
        const std::vector<Consistency> group =
            consistency_of_group(graph, marginals, loops.subspan(first, std::min(most_in_group, loops.size() - first)));
        result.insert(result.end(), group.begin(), group.end());
    }
    return result;
}

Solution minimise_robustly(PoseGraph& graph) {
    for (RelativeEdge& loop : graph.loops) {
        loop.weight = 1.0;
    }
    Solution solution = minimise(graph);
    double largest = 0.0;
    for (const RelativeEdge& loop : graph.loops) {
        largest = std::max(largest, squared_error(graph, loop));
    }
    if (largest <= truncation) {
        return solution;
    }
    constexpr double growth = 2.0;
    constexpr int most_rounds = 60;
    double convexity = truncation / (2.0 * largest - truncation);
    for (int round = 0; round < most_rounds; ++round) {
        bool decided = true;
        for (RelativeEdge& loop : graph.loops) {
            const double error = squared_error(graph, loop);
            if (error >= (convexity + 1.0) / convexity * truncation) {
                loop.weight = 0.0;
            } else if (error <= convexity / (convexity + 1.0) * truncation) {
                loop.weight = 1.0;
            } else {
                loop.weight = std::sqrt(truncation / error * convexity * (convexity + 1.0)) - convexity;
                decided = false;
            }
        }
        solution = minimise(graph, 10);
        if (decided) {
            break;
        }
        convexity *= growth;
    }
    return solution;
}

}  // namespace ddtool::graph
