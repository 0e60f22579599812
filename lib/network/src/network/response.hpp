#pragma once

#include <span>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// How matching answers the odometry: for each particle x, how far its predicted motion lies from the swarm's mean, and
/// y, how far its matched motion does, both along the direction that matching leaves widest compared with the
/// prediction, in standard deviations of the prediction. A scan that says nothing of that direction gives every
/// particle back what it came with: a diagonal. One that fixes it gives all the same: a level line. The slope between
/// is the share of the odometry's noise that is left (docs/imaging.md), and needs far fewer particles to be seen than
/// the ratio of two spreads, since every particle is compared with itself. Predicted spreads below least_spread_m count
/// as that. Particles that are not finite are left out.
void response(std::span<const SnapshotParticle> particles, double least_spread_m, std::vector<Point2>& points);

}  // namespace ddtool
