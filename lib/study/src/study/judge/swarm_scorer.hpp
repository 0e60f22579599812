#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool::detection {

/// A swarm, as it lies in a snapshot or in a mapped data set.
using Particles = std::span<const SnapshotParticle>;

/// Scores of many swarms, one each; the higher, the more degenerate. A network, a rule or a test's lambda.
using SwarmScorer = std::function<std::vector<double>(std::span<const Particles> swarms)>;

/// Looks at one swarm after the other.
inline SwarmScorer one_by_one(std::function<double(Particles)> score) {
    return [score = std::move(score)](std::span<const Particles> swarms) {
        std::vector<double> scores;
        scores.reserve(swarms.size());
        for (const Particles swarm : swarms) {
            scores.push_back(score(swarm));
        }
        return scores;
    };
}

}  // namespace ddtool::detection
