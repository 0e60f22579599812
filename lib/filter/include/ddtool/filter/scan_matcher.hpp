#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// The scan in the form matching reads: in cells, padded to whole lanes. Made once a scan for all particles.
struct MatchPoints {
    std::vector<float> x, y;                ///< end points in cells, robot frame
    std::vector<float> normal_x, normal_y;  ///< surface normals, robot frame
    std::vector<float> along_weight;
    std::vector<float> counts;  ///< 1 for a beam, 0 for padding
    std::size_t beams = 0;

    MatchPoints() = default;
    MatchPoints(const ScanPoints& points, double cell_size_m);
};

/// From the nearest occupied point to each end point, in cells in the world frame.
struct Residuals {
    std::vector<float> x, y;
    std::vector<float> found;  ///< 1 where there is an occupied point near
    std::vector<float> known;  ///< 1 where there is, or the end point lies in observed ground
};

/// Searches look at every third block of beams; their outcome is judged by all of them.
inline constexpr std::size_t search_stride = 3;

struct ScanMatcherSettings {
    /// Beams that end farther than this from any occupied point say nothing of the pose (Tukey's biweight).
    double reach_m = 0.16;
    int max_iterations = 25;
    /// Standard deviation of an end point's distance to the mapped surface.
    double beam_sigma_m = 0.05;
    /// A match whose mean beam score is lower starts a wide search.
    double doubtful_score = 0.8;
    double search_turn_rad = 0.35;
    double search_distance_m = 0.6;
};

/// What the motion model says of the pose: the match may leave it where the scan has something to say.
struct PosePrior {
    double sigma_along_m = 1.0;
    double sigma_across_m = 1.0;
    double sigma_turn_rad = 1.0;
};

/// The prior as information about (x, y, theta) in the world, for a robot of that heading.
Eigen::Matrix3d information_of(const PosePrior& prior, double theta_rad);

struct ScanMatch {
    Pose2 pose;          ///< world_from_robot
    double score = 0.0;  ///< mean over the beams of (1 - q / reach^2)^3, q the squared distance to the mapped surface
    /// Information the scan has of the pose (x, y, theta in the world frame; 1/m^2, 1/(m rad), 1/rad^2).
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    /// Sum over the beams of log p(z | x, m): -min(q / (2 sigma^2), the value of a miss). A beam that ends in ground
    /// never observed counts as the mean of the others: if it counted as a miss, every particle that lags behind and so
    /// sees less of the unknown would gain by it, and corridors would come out short.
    double log_likelihood = 0.0;

    /// No setting: a scan that fits by a tenth of its beams fits by chance, and every method leans on this one border.
    static constexpr double least_score = 0.1;
    /// Whether this counts as a match at all: where the scan fits worse, it says nothing of the pose.
    [[nodiscard]] bool accepted() const { return score >= least_score; }
};

/// Finds the pose at which a scan fits a grid, by Gauss-Newton on the distances from the end points to the nearest
/// occupied points, measured across the surface the scan sees; from a wide search where that ends in doubt.
/// Holds buffers only: one a thread, for any number of grids.
class ScanMatcher {
public:
    ScanMatcher(const ScanMatcherSettings& settings, double cell_size_m);

    /// initial: world_from_robot as the motion model predicted it.
    ScanMatch match(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial, const PosePrior& prior);
    /// How the scan fits at a pose given.
    ScanMatch evaluate(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose);
    /// Score at a pose, every `stride`-th block of beams.
    double score(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride = 1);

private:
    struct Normal {
        ScanMatch match;  ///< without its log-likelihood
        Eigen::Vector3d gradient;
    };

    void find_residuals(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride);
    /// Both of the residuals found last, at every beam, at the same pose.
    [[nodiscard]] Normal normal_equations(const MatchPoints& points, const Pose2& pose) const;
    [[nodiscard]] double log_likelihood(const MatchPoints& points, double theta_rad) const;
    ScanMatch refine(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& start, const Pose2& predicted,
                     const Eigen::Matrix3d& prior_information);
    Pose2 search(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& start);

    ScanMatcherSettings settings_;
    double cell_size_m_;
    float inverse_reach2_;  ///< 1/cells^2
    Residuals residuals_;
};

}  // namespace ddtool
