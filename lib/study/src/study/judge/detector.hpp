#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ddtool/network/image_settings.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"
#include "scores/confusion.hpp"

namespace ddtool::judge {

/// A swarm, as it lies in a snapshot or in a mapped data set.
using Particles = std::span<const SnapshotParticle>;

/// Gives one score for each swarm; the higher the score, the more degenerate the swarm. It may be a network, a rule or
/// a lambda in a test.
using SwarmScorer = std::function<std::vector<double>(std::span<const Particles> swarms)>;

/// Makes a scorer of swarms from a function that scores a single swarm.
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

/// Decides whether swarms are degenerate; with the origin of this decision, such as the training data.
struct Detector {
    std::string name;
    std::string swarm;                  ///< what it looks at: absolute, step, both, or the particles' weights
    std::string label;                  ///< the label that it was trained or fitted on
    std::string split;                  ///< the split whose train part it was trained or fitted on
    std::optional<std::uint64_t> seed;  ///< of its training
    std::string family;                 ///< the same for networks that differ in nothing but the seed; empty for a rule
    std::string decision;               ///< in words, such as "above 0.5"
    SwarmScorer score;
    double threshold = 0.5;  ///< degenerate above it; NaN: never fitted
    bool is_degree = false;  ///< its scores are in 0..1 and meant as probabilities
    ImageSettings image;     ///< what it sees, or what to show of its mistakes

    /// Whether this is a trained network rather than a rule.
    [[nodiscard]] bool is_model() const { return !family.empty(); }
};

/// How well a detector's scores decide some samples.
struct Performance {
    std::size_t samples = 0;
    double degenerate_share = 0.0;  ///< of the samples
    Confusion confusion;            ///< empty for a detector without a threshold
    double auc = 0.0;
};

Performance performance_of(const Detector& detector, std::span<const double> scores,
                           const std::vector<bool>& degenerate);

}  // namespace ddtool::judge
