#include "graph/loop_edges.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/squared.hpp"
#include "graph/loop_search.hpp"
#include "graph/marginals.hpp"
#include "graph/robust.hpp"
#include "graph/stretches.hpp"

namespace ddtool::graph {
namespace {

/// The local map of the track reaches back so far; nearer stretches say nothing new.
constexpr double least_way_m = 20.0;
/// Stretches whose anchors are at most so far apart see the same walls.
constexpr double nearby_m = 3.0;
/// Each stretch is compared with at most so many older ones in a round, each so far on the way from the others.
constexpr std::size_t most_partners = 3;
constexpr double partners_apart_m = 6.0;
constexpr int rounds = 3;
/// What the gate is at least, because the graph's covariance leaves out what all matches get wrong alike.
const Eigen::Vector3d least_gate(0.05, 0.05, 0.02);
/// The graph's deviations count as so much more.
constexpr double caution = 1.5;

/// An older stretch that a newer one may be at.
struct Candidate {
    std::size_t older = 0;
    double distance_m = 0.0;
    Eigen::Matrix3d covariance;  ///< of newer's pose seen from older
};

using Pair = std::pair<std::size_t, std::size_t>;  ///< older and newer stretch

class LoopCloser {
public:
    LoopCloser(PoseGraph& graph, const std::vector<Node>& nodes, const RbpfSettings& settings)
        : graph_(graph),
          open_(graph),
          stretches_(stretches_of(graph.poses)),
          maps_(nodes, open_.poses, settings),
          search_(settings) {}

    std::vector<Loop> close() {
        for (int round = 0; round < rounds; ++round) {
            if (!compare_more()) {
                break;
            }
            solve();
        }
        std::vector<Loop> all;
        for (auto& [pair, loop] : loops_) {
            all.push_back(std::move(loop));
        }
        std::stable_sort(all.begin(), all.end(), [](const Loop& a, const Loop& b) { return a.edge.to < b.edge.to; });
        return all;
    }

private:
    /// Compares pairs that were not compared before. Returns whether there is a new match.
    bool compare_more() {
        const Marginals marginals(graph_);
        bool found = false;
        for (std::size_t newer = 1; newer < stretches_.size(); ++newer) {
            for (const Candidate& candidate : candidates_of(newer, marginals)) {
                const Pair pair{candidate.older, newer};
                if (loops_.contains(pair)) {
                    continue;
                }
                loops_[pair] = compared(candidate, newer);
                found |= loops_[pair].refusal.empty();
            }
        }
        return found;
    }

    [[nodiscard]] std::vector<Candidate> candidates_of(std::size_t newer, const Marginals& marginals) const {
        const std::size_t b = stretches_[newer].anchor;
        const Eigen::MatrixXd with_b = marginals.with_node(b);
        std::vector<Candidate> near;
        for (std::size_t older = 0; older < newer; ++older) {
            if (stretches_[newer].way_m - stretches_[older].way_m < least_way_m) {
                break;
            }
            const std::size_t a = stretches_[older].anchor;
            Eigen::Matrix3d covariance = squared(caution) * marginals.relative(graph_, a, b, with_b);
            covariance.diagonal() += least_gate.cwiseAbs2();
            const double apart_m = distance_m(graph_.poses[a], graph_.poses[b]);
            if (apart_m <= nearby_m + 2.0 * std::sqrt(covariance.topLeftCorner<2, 2>().trace())) {
                near.push_back({older, apart_m, covariance});
            }
        }
        std::stable_sort(near.begin(), near.end(),
                         [](const Candidate& a, const Candidate& b) { return a.distance_m < b.distance_m; });
        std::vector<Candidate> chosen;
        for (const Candidate& candidate : near) {
            const double way_m = stretches_[candidate.older].way_m;
            const bool apart = std::none_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
                return std::abs(stretches_[other.older].way_m - way_m) < partners_apart_m;
            });
            if (apart && chosen.size() < most_partners) {
                chosen.push_back(candidate);
            }
        }
        return chosen;
    }

    Loop compared(const Candidate& candidate, std::size_t newer) {
        const std::size_t a = stretches_[candidate.older].anchor;
        const std::size_t b = stretches_[newer].anchor;
        const auto older_map = maps_.map_of(stretches_[candidate.older]);
        const auto newer_map = maps_.map_of(stretches_[newer]);
        const LoopMatch match =
            search_.match(*older_map, *newer_map, between(graph_.poses[a], graph_.poses[b]), candidate.covariance);
        return {.edge = {.from = a, .to = b, .measured = match.older_from_newer, .information = match.information},
                .agreed = match.agreed,
                .open_along = match.open_along,
                .refusal = match.refusal};
    }

    /// Decides between all matches so far, from the graph without loops on.
    void solve() {
        std::vector<Loop*> matched;
        std::vector<RelativeEdge> edges;
        for (auto& [pair, loop] : loops_) {
            if (loop.refusal.empty() || loop.edge.information.trace() > 0.0) {
                loop.refusal.clear();
                matched.push_back(&loop);
                edges.push_back(loop.edge);
            }
        }
        const std::vector<Consistency> consistency = consistency_of(open_, edges);
        graph_ = open_;
        std::vector<Loop*> solved;
        for (std::size_t i = 0; i < matched.size(); ++i) {
            if (consistency[i].kept) {
                graph_.loops.push_back(edges[i]);
                solved.push_back(matched[i]);
            } else {
                matched[i]->refusal = consistency[i].within_gate
                                          ? "contradicts " + std::to_string(consistency[i].contradicts) + " other loops"
                                          : "contradicts the odometry and the matches in between";
            }
        }
        minimise_robustly(graph_);
        for (std::size_t i = 0; i < solved.size(); ++i) {
            solved[i]->edge.weight = graph_.loops[i].weight;
            if (graph_.loops[i].weight < 0.5) {
                solved[i]->refusal = "contradicts the solution of all others";
            }
        }
    }

    PoseGraph& graph_;
    const PoseGraph open_;  ///< solved, without loops
    std::vector<Stretch> stretches_;
    StretchMaps maps_;
    LoopSearch search_;
    std::map<Pair, Loop> loops_;
};

}  // namespace

std::vector<Loop> close_loops(PoseGraph& graph, const std::vector<Node>& nodes, const RbpfSettings& settings) {
    return LoopCloser(graph, nodes, settings).close();
}

}  // namespace ddtool::graph
