#pragma once

#include <span>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// How the matched motion depends on the predicted one. For each particle, x is how far its predicted motion is from
/// the swarm's mean, and y how far its matched motion is from the mean of the matched motions. Both are measured along
/// the direction in which matching leaves the largest spread compared with the prediction, in standard deviations of
/// the prediction. If the scan says nothing about that direction, every particle keeps its deviation and the points
/// form a diagonal. If the scan determines it, all particles get the same value and the points form a level line. The
/// slope in between is the share of the odometry's noise that is left (docs/imaging.md). It can be seen with far fewer
/// particles than the ratio of two spreads, since every particle is compared with itself. Predicted standard deviations
/// below least_spread_m (metres) are replaced by it. Particles that are not finite are left out.
void response(std::span<const SnapshotParticle> particles, double least_spread_m, std::vector<Point2>& points);

}  // namespace ddtool
