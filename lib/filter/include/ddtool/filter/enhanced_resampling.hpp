#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct EnhancedResamplingSettings {
    double drop_below = 0.5;       ///< particles of a lower weight are dropped, in units of the mean weight
    double perturbation_m = 0.01;  ///< sigma of the noise for a particle of the mean weight
    double least_weight = 0.2;     ///< lower bound of w in sigma / w, in units of the mean weight
    double most_weight = 5.0;      ///< upper bound of w
};

/// The paper's "Enhanced Resampling" (eq. random_perturbation). Particles of low weight are dropped and their places
/// filled by systematic resampling of the others. The position of each descendant is the mean of its parent's and of
/// the nearest other survivor's, moved by normal noise of standard deviation sigma / w, where w is the parent's weight
/// in units of the mean weight, clamped to the bounds. The heading stays the parent's.
class EnhancedResampling : public Resampling {
public:
    explicit EnhancedResampling(const EnhancedResamplingSettings& settings) : settings_(settings) {}
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, RandomStream& random) const override;

private:
    EnhancedResamplingSettings settings_;
};

}  // namespace ddtool
