#pragma once

#include <vector>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The swarms of the highest degrees of a run, seconds apart, so that one bad place does not fill the list. Holds no
/// more than `most` of them at any time.
class WorstMoments {
public:
    struct Moment {
        ParticleSnapshot swarm;
        double degree = 0.0;
    };

    explicit WorstMoments(std::size_t most = 6, double apart_s = 3.0);

    /// Takes the swarm where its degree is above 0 and above that of every moment near it, and of the least kept one
    /// when the list is full.
    void offer(const ParticleSnapshot& swarm, const Degeneracy& degeneracy);

    /// The highest degree first.
    [[nodiscard]] std::vector<Moment> ranked() const;

private:
    std::size_t most_;
    double apart_s_;
    std::vector<Moment> kept_;
};

}  // namespace ddtool
