#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "ddtool/filter/beam_surfaces.hpp"
#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// Searches score only every third block of beams; their result is then evaluated with all beams.
inline constexpr std::size_t search_stride = 3;

struct ScanMatcherSettings {
    /// Beams that end farther than this from any occupied point have no effect on the pose (Tukey's biweight).
    double reach_m = 0.16;
    int max_iterations = 25;
    /// Standard deviation of an end point's distance to the mapped surface.
    double beam_sigma_m = 0.05;
    /// A match whose mean beam score is below this starts a wide search.
    double doubtful_score = 0.8;
    double search_turn_rad = 0.35;   ///< half width of the wide search
    double search_distance_m = 0.6;  ///< half width of the wide search, along x and y
};

/// Uncertainty of the pose that the motion model predicts, in the robot's frame. The match moves away from the
/// prediction only as far as the scan's information outweighs this.
struct PosePrior {
    double sigma_along_m = 1.0;
    double sigma_across_m = 1.0;
    double sigma_turn_rad = 1.0;
};

/// The prior as an information matrix about (x, y, theta) in the world, for a robot with heading theta_rad.
Eigen::Matrix3d information_of(const PosePrior& prior, double theta_rad);

/// How a wide search tries the headings and places around its start.
enum class SearchOrder {
    headings_first,  ///< all headings where the robot should be, then all places with the best of these
    all_pairs        ///< each heading at each place: finds a pose that is off in both, for eight times the work
};

struct ScanMatch {
    Pose2 pose;          ///< world_from_robot
    double score = 0.0;  ///< mean over the beams of (1 - q / reach^2)^3; q: squared distance to the mapped surface
    /// Information that the scan gives about the pose (x, y, theta in the world frame; 1/m^2, 1/(m rad), 1/rad^2).
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    /// Mean of q over the beams, m^2, each with its weight in the match, so that what is not in the map hardly counts;
    /// 0 if no beam has any.
    double misfit_m2 = 0.0;
    /// Sum over the beams of log p(z | x, m) = -min(q / (2 sigma^2), reach^2 / (2 sigma^2)), where the second value is
    /// that of a miss. A beam that ends in ground never observed counts as the mean of the others. If it counted as a
    /// miss, every particle that lags behind would gain, since it sees less unknown ground, and corridors would come
    /// out too short.
    double log_likelihood = 0.0;

    /// Not a setting: a scan with a mean score below a tenth fits only by chance, and every method relies on this one
    /// limit.
    static constexpr double least_score = 0.1;
    /// Whether this counts as a match at all. If the scan fits worse, it says nothing about the pose.
    [[nodiscard]] bool accepted() const { return score >= least_score; }
};

/// Finds the pose at which a scan fits a grid. It uses Gauss-Newton on the distances from the end points to the mapped
/// surfaces. These are measured across the line through the mapped points around the nearest one (MapLine). Where they
/// form no line, the nearest one alone counts, across the surface that the scan sees. Where the result is doubtful, a
/// wide search, which has no use for lines, provides a second start.
/// An object holds only buffers: each thread needs its own, which serves any number of grids of that cell size.
class ScanMatcher {
public:
    ScanMatcher(const ScanMatcherSettings& settings, double cell_size_m);

    /// initial: world_from_robot as the motion model predicted it; prior: its uncertainty. `points` must be in cells of
    /// the same size as the grid's. The result may have to be rejected: see ScanMatch::accepted().
    ScanMatch match(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial, const PosePrior& prior);
    /// The parts of match(), for who matches one scan in many maps: the match without a wide search,
    ScanMatch match_directly(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                             const PosePrior& prior);
    /// whether it calls for a wide search,
    [[nodiscard]] bool is_doubtful(const ScanMatch& direct) const { return direct.score < settings_.doubtful_score; }
    /// the pose that the wide search around `initial` finds,
    Pose2 search(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                 SearchOrder order = SearchOrder::headings_first);
    /// and the match from the start that fits best, or `direct` if that has the higher score. `starts` is not empty.
    ScanMatch match_from(std::span<const Pose2> starts, const ScanMatch& direct, const OccupancyGrid& grid,
                         const MatchPoints& points, const Pose2& initial, const PosePrior& prior);
    /// How the scan fits at the given pose (world_from_robot), which is not changed.
    ScanMatch evaluate(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose);
    /// Score at a pose (world_from_robot), from every `stride`-th block of beams. It is divided by the number of all
    /// beams, so compare only scores of the same stride.
    double score(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride = 1);

private:
    struct Normal {
        ScanMatch match;  ///< without its log-likelihood
        Eigen::Vector3d gradient;
    };

    /// Match and gradient from the latest residuals, which must be of all beams and at the same pose.
    [[nodiscard]] Normal normal_equations(const MatchPoints& points, const Pose2& pose) const;
    [[nodiscard]] double log_likelihood(const MatchPoints& points) const;
    /// As evaluate() and score(), in the same grid and for the same scan as the call before.
    ScanMatch evaluated(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose);
    double scored(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride);
    ScanMatch refine(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& start, const Pose2& predicted,
                     const Eigen::Matrix3d& prior_information);

    ScanMatcherSettings settings_;
    double cell_size_m_;
    float inverse_reach2_;  ///< 1/cells^2
    BeamSurfaces surfaces_;
};

}  // namespace ddtool
