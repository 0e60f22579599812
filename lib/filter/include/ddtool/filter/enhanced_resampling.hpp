#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct EnhancedResamplingSettings {
    double drop_below = 0.5;       ///< particles of a lower weight are dropped; the mean weight is one
    double perturbation_m = 0.01;  ///< sigma at the mean weight
    double least_weight = 0.2;     ///< bounds of the weight in 1/w
    double most_weight = 5.0;
};

/// The paper's "Enhanced Resampling" (eq. random_perturbation): low weights are dropped and their places filled by
/// systematic resampling of the others; each survivor's position is fused with the nearest other survivor's by the
/// mean, and moved by normal noise of sigma / w, w normalised to mean one and bounded. The heading stays the parent's.
class EnhancedResampling : public Resampling {
public:
    explicit EnhancedResampling(const EnhancedResamplingSettings& settings) : settings_(settings) {}
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, RandomStream& random) const override;

private:
    EnhancedResamplingSettings settings_;
};

}  // namespace ddtool
