#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// exp(l - max l), scaled to sum to one. Non-finite log weights count as zero; if none is finite, all are equal.
std::vector<double> normalised_weights(std::span<const double> log_weights);

/// The normalised weights of a swarm.
std::vector<double> weights_of(std::span<const SnapshotParticle> particles);

/// Effective sample size 1 / sum w^2 of normalised weights (Doucet et al. 2000; Grisetti et al. 2007, eq. 20).
double effective_sample_size(std::span<const double> weights);

/// Systematic resampling: for each of weights.size() slots the particle that fills it, in rising order.
/// offset in [0, 1) places the comb. Weights are normalised.
std::vector<std::size_t> systematic_resampling(std::span<const double> weights, double offset);

/// The paper's dispersion R = var(w) / |mean(w)| with the population variance (its eq. label_explain); 0 for no
/// weights or a zero mean. With accumulated log-likelihoods, which are negative, the magnitude of the mean counts.
double dispersion(std::span<const double> weights);

}  // namespace ddtool
