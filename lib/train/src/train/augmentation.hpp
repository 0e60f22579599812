#pragma once

#include <span>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

/// The same swarm seen from another side, or with fewer particles: poses and motions turned about the swarm's middle
/// and the robot's previous pose, mirrored, thinned to a number of particles drawn evenly in its logarithm between
/// least_particles and all. What the label is made from does not change.
void augment(std::vector<SnapshotParticle>& particles, const AugmentationSettings& settings, RandomStream& random);

}  // namespace ddtool::train
