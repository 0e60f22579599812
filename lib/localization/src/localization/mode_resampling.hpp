#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ddtool/filter/strategies.hpp"

namespace ddtool::localization {

struct ModeResamplingSettings {
    std::size_t least_particles = 30;
    std::size_t most_particles = 500;
    double kld_error = 0.1;  ///< the distance from the true distribution that KLD sampling allows
};

/// Resampling for localisation. The number of particles follows from how many cells of the space of poses they occupy
/// (KLD sampling: Fox, "Adapting the sample size in particle filters through KLD-sampling", IJRR 2003). Places that
/// cannot be told apart keep their weights instead of being drawn lots for: each mode has its own share of particles,
/// which carry its weight (Vermaak, Doucet, Perez, "Maintaining multi-modality through mixture tracking", ICCV 2003).
class ModeResampling : public Resampling {
public:
    explicit ModeResampling(const ModeResamplingSettings& settings) : settings_(settings) {}
    [[nodiscard]] bool is_due(std::span<const SnapshotParticle> particles) const override;
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, RandomStream& random) const override;

private:
    [[nodiscard]] std::size_t wanted(std::span<const SnapshotParticle> particles) const;

    ModeResamplingSettings settings_;
};

}  // namespace ddtool::localization
