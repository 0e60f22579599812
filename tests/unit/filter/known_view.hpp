#pragma once

#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/filter/strategies.hpp"
#include "room_scans.hpp"

namespace ddtool {

/// A scan, the grid that was made from it at its true pose, and the context that a correction gets for a particle
/// there.
struct KnownView {
    explicit KnownView(const sim::World& world, double range_max_m = 30.0)
        : points(exact_points(world, pose, 360, range_max_m)) {
        ScanInserter().insert(grid, points, pose);
    }

    /// The context of a particle that was sampled at `predicted`, while the odometry expects it at `odometry`.
    MatchContext context(const Pose2& predicted, const Pose2& odometry, double odometry_sd_m = 0.003,
                         double odometry_sd_rad = 0.0005) {
        Eigen::Vector3d information(odometry_sd_m, odometry_sd_m, odometry_sd_rad);
        information = information.cwiseAbs2().cwiseInverse();
        return {.matcher = matcher,
                .grid = grid,
                .points = match_points,
                .predicted = predicted,
                .prior = prior,
                .odometry = odometry,
                .odometry_information = information.asDiagonal(),
                .degeneracy = {}};
    }
    /// The context of a particle that was sampled at the odometry's pose, in a swarm with this degree of degeneracy.
    MatchContext context_of_degree(double degree, const Pose2& odometry, double odometry_sd_m = 0.003,
                                   double odometry_sd_rad = 0.0005) {
        MatchContext result = context(odometry, odometry, odometry_sd_m, odometry_sd_rad);
        result.degeneracy.degree = degree;
        return result;
    }
    ScanMatch match_from(const Pose2& predicted) { return matcher.match(grid, match_points, predicted, prior); }

    Pose2 pose{0.21, -0.13, 0.0};
    ScanPoints points;
    OccupancyGrid grid{OccupancySettings{}};
    MatchPoints match_points{points, OccupancySettings{}.cell_size_m};
    ScanMatcher matcher{ScanMatcherSettings{}, OccupancySettings{}.cell_size_m};
    PosePrior prior{0.04, 0.04, 0.03};
};

/// Two walls along x, whose ends are out of the lidar's range.
inline sim::World long_corridor() { return room(200.0, 2.0); }

}  // namespace ddtool
