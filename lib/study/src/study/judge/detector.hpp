#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ddtool/network/image_settings.hpp"
#include "study/judge/swarm_scorer.hpp"

namespace ddtool::detection {

/// Says of swarms whether they are degenerate, and where it has that from.
struct Detector {
    std::string name;
    std::string swarm;                  ///< what it looks at: absolute, step, both, or the particles' weights
    std::string label;                  ///< that it was trained or fitted on
    std::string split;                  ///< whose part train it was trained or fitted on
    std::optional<std::uint64_t> seed;  ///< of its training
    std::string family;                 ///< the same for networks that differ in nothing but the seed; empty for a rule
    std::string decision;               ///< in words, such as "above 0.5"
    SwarmScorer score;
    double threshold = 0.5;  ///< degenerate above it; NaN: never fitted
    bool is_degree = false;  ///< its scores are in 0..1 and meant as probabilities
    ImageSettings image;     ///< what it sees, or what to show of its mistakes

    /// A trained network, not a rule.
    [[nodiscard]] bool is_model() const { return !family.empty(); }
};

}  // namespace ddtool::detection
