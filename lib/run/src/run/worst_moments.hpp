#pragma once

#include <vector>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// Collects the swarms with the highest degrees of degeneracy in a run. Any two of them are at least `apart_s` seconds
/// apart, so that one bad place does not fill the list. At most `most` swarms are held at any time.
class WorstMoments {
public:
    struct Moment {
        ParticleSnapshot swarm;
        double degree = 0.0;
    };

    explicit WorstMoments(std::size_t most = 6, double apart_s = 3.0);

    /// Keeps the swarm if its degree is above 0 and above that of every kept moment less than `apart_s` away, which it
    /// then replaces. If the list is full, the degree must also be above the lowest kept one, which is then dropped.
    void offer(const ParticleSnapshot& swarm, const Degeneracy& degeneracy);

    /// Returns the kept moments, the highest degree first.
    [[nodiscard]] std::vector<Moment> ranked() const;

private:
    std::size_t most_;
    double apart_s_;
    std::vector<Moment> kept_;
};

}  // namespace ddtool
