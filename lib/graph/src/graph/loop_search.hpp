#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "ddtool/filter/rbpf.hpp"
#include "graph/stretches.hpp"

namespace ddtool::graph {

/// How the points of one local map fit another.
struct Overlap {
    std::size_t points = 0;
    std::size_t known = 0;   ///< points that lie in ground the other map observed
    std::size_t agreed = 0;  ///< of those, the ones that lie on its walls

    [[nodiscard]] double known_share() const;
    [[nodiscard]] double agreed_share() const;  ///< of the known points
};
Overlap overlap(const StretchMap& from, const OccupancyGrid& in, const Pose2& in_from_other);

/// Where a stretch lies relative to an older one, by their local maps.
struct LoopMatch {
    Pose2 older_from_newer;
    /// About older_from_newer, in the frame of the newer; zero along directions in which no single place fits best.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double agreed = 0.0;      ///< the lower of both maps' Overlap::agreed_share()
    std::string refusal;      ///< why this is no loop, in words; empty if it is one
    bool open_along = false;  ///< whether a direction is left out because more than one place fits
};

/// Matches local maps: every place of a lattice within the gate is tried on a coarse map, the best ones are refined by
/// the filter's matcher, and those that fit as well as the best tell in which directions the match is clear (Olson
/// 2009; Hess et al., "Real-time loop closure in 2D lidar SLAM", ICRA 2016, search the same lattice by branch and
/// bound, which finds the best place alone). An object holds buffers: one for each thread.
class LoopSearch {
public:
    explicit LoopSearch(const RbpfSettings& settings);

    /// \param predicted older_from_newer by the graph
    /// \param covariance of it (x, y, theta in the older's frame)
    LoopMatch match(const StretchMap& older, const StretchMap& newer, const Pose2& predicted,
                    const Eigen::Matrix3d& covariance);

private:
    struct Place {
        Pose2 pose;
        double score = 0.0;
    };
    [[nodiscard]] std::vector<Place> coarse_places(const StretchMap& older, const StretchMap& newer,
                                                   const Pose2& predicted, double half_m, double half_rad) const;

    struct Peak {
        Eigen::Matrix3d information;
        bool is_open = false;  ///< along one direction
    };
    Peak peak_of(const StretchMap& older, const StretchMap& newer, const Pose2& pose,
                 const Eigen::Matrix3d& information);

    RbpfSettings settings_;
    ScanMatcher matcher_;
};

}  // namespace ddtool::graph
