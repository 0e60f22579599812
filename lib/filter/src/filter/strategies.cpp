#include "ddtool/filter/strategies.hpp"

#include "swarm/weights.hpp"

namespace ddtool {

std::vector<Descendant> SystematicResampling::resample(std::span<const SnapshotParticle> particles,
                                                       RandomStream& random) const {
    std::vector<Descendant> descendants;
    for (const std::size_t parent : systematic_resampling(weights_of(particles), random.uniform())) {
        descendants.push_back({parent, particles[parent].pose});
    }
    return descendants;
}

}  // namespace ddtool
