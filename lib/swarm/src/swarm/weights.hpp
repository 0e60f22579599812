#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The weights exp(l - max l) of the log weights l, scaled to sum to one. A log weight that is not finite gives weight
/// zero; if no log weight is finite, all weights are equal.
std::vector<double> normalised_weights(std::span<const double> log_weights);

/// The normalised weights of a swarm.
std::vector<double> weights_of(std::span<const SnapshotParticle> particles);

/// Effective sample size 1 / sum w^2 of normalised weights (Doucet et al. 2000; Grisetti et al. 2007, eq. 20).
double effective_sample_size(std::span<const double> weights);

/// Systematic resampling: for each of weights.size() slots, the index of the particle that fills it, in rising order.
/// `offset` in [0, 1) shifts the evenly spaced sampling points. The weights must be normalised.
std::vector<std::size_t> systematic_resampling(std::span<const double> weights, double offset);

/// The paper's dispersion R = var(w) / |mean(w)| with the population variance (its eq. label_explain). It is 0 if there
/// are no weights or their mean is zero. The magnitude of the mean is used because accumulated log-likelihoods are
/// negative.
double dispersion(std::span<const double> weights);

}  // namespace ddtool
