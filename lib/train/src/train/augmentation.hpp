#pragma once

#include <span>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

/// Changes a swarm as if it were seen from another side, or had fewer particles. Poses are rotated about the swarm's
/// centre and motions about the robot's previous pose, and both may be mirrored. The number of particles is drawn
/// between least_particles and all, evenly in its logarithm. The label does not depend on any of this.
void augment(std::vector<SnapshotParticle>& particles, const AugmentationSettings& settings, RandomStream& random);

}  // namespace ddtool::train
