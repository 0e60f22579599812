#pragma once

#include <Eigen/Core>

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct CorrelativeSearchSettings {
    double window_m = 0.2;  ///< half width, about the odometry's pose
    double window_rad = 0.1;
    int steps = 4;  ///< to each side; each level's window is one step of the level before
    int levels = 3;
    double degenerate_share = 0.02;  ///< smaller over larger eigenvalue of the normals' scatter
};

/// The principal components of the surface normals that a scan sees (world frame): the scatter sum of n n' over the
/// points that lie on a line, divided by their number.
Eigen::Matrix2d normal_scatter(const MatchPoints& points, double theta_rad);

/// Our re-implementation of DN-CSM: correlative scan matching (Olson, "Real-time correlative scan matching", ICRA 2009:
/// every pose of a lattice about the odometry's is scored) with degeneracy seen in the principal components of the
/// scan's dense normals. Where the smaller one vanishes, the lattice has no extent along it: the odometry is kept
/// there.
class CorrelativeSearch : public PoseCorrection {
public:
    explicit CorrelativeSearch(const CorrelativeSearchSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    CorrelativeSearchSettings settings_;
};

}  // namespace ddtool
