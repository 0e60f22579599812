#pragma once

#include <Eigen/Core>

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct CorrelativeSearchSettings {
    double window_m = 0.2;    ///< half width of the first level's window about the odometry's pose
    double window_rad = 0.1;  ///< the same for the heading
    int steps = 4;            ///< to each side of the centre; a level's half width is one step of the level before it
    int levels = 3;
    double degenerate_share =
        0.02;  ///< degenerate at or below this ratio of normal_scatter()'s eigenvalues, smaller over larger
};

/// Mean of n n' over the surface normals n that a scan sees, in the world frame; its eigenvectors are the normals'
/// principal components. theta_rad is the robot's heading in the world. A normal weighs 1 - along_weight of its point,
/// so that points on a line count and isolated points do not. The matrix is zero where no point lies on a line.
Eigen::Matrix2d normal_scatter(const MatchPoints& points, double theta_rad);

/// Our re-implementation of DN-CSM: correlative scan matching (Olson, "Real-time correlative scan matching", ICRA
/// 2009), which scores every pose of a lattice about the odometry's pose. Degeneracy is detected from the principal
/// components of the scan's dense normals: where the smaller component vanishes, the lattice does not extend along its
/// direction, so the odometry's position is kept there.
class CorrelativeSearch : public PoseCorrection {
public:
    explicit CorrelativeSearch(const CorrelativeSearchSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    CorrelativeSearchSettings settings_;
};

}  // namespace ddtool
