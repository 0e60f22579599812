#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ddtool/filter/hit_map.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// The defaults are those of slam_gmapping, whose names for them are lstep, astep, iterations, sigma and lsigma.
struct HillClimbSettings {
    double step_m = 0.05;                ///< the first steps along the world's axes
    double turn_rad = 0.05;              ///< the first turns
    int halvings = 5;                    ///< how often steps and turns are halved
    double score_width_m2 = 0.05;        ///< a beam that ends d from the map scores exp(-d^2 / this)
    double likelihood_width_m2 = 0.075;  ///< and its log-likelihood is -d^2 / this
};

/// How well a scan fits a map at a pose.
struct BeamFit {
    double score = 0.0;           ///< sum over the beams, each from 0 to 1; a beam without a hit near its end scores 0
    double log_likelihood = 0.0;  ///< sum over the beams
    std::size_t beams = 0;

    [[nodiscard]] double mean_score() const { return beams == 0 ? 0.0 : score / static_cast<double>(beams); }
};

/// The scan matching of OpenSLAM GMapping (Grisetti, Stachniss, Burgard, "Improved techniques for grid mapping with
/// Rao-Blackwellized particle filters", IEEE T-RO 2007; its likelihood is that of Thrun et al. 2005, 6.4, cut off
/// beyond the neighbouring cells). An object holds only buffers: each thread needs its own, which serves any number of
/// maps.
class HillClimb {
public:
    /// A beam that ends in a cell without a hit in the 3 x 3 cells about it, in ground never seen, too, counts as if it
    /// ended at the root of this from the map. It costs far more than the worst beam with a hit, whose d^2 is at most
    /// 0.02 m^2 in cells of 5 cm.
    static constexpr double missed_m2 = 0.5;

    explicit HillClimb(const HillClimbSettings& settings) : settings_(settings) {}

    struct Found {
        Pose2 pose;  ///< world_from_laser; the angle is not wrapped
        BeamFit fit;
    };

    /// `ends`: the end points of the beams in the laser's frame, in metres.
    [[nodiscard]] BeamFit fit(const HitMap& map, std::span<const Point2> ends, const Pose2& world_from_laser);
    /// From `start`, goes to the best of the six poses one step along or against x or y or one turn away as long as
    /// that scores more, then halves the step and the turn, and so on.
    [[nodiscard]] Found climb(const HitMap& map, std::span<const Point2> ends, const Pose2& start);

private:
    using Turned = std::vector<Point2>;
    static void turn(std::span<const Point2> ends, double angle_rad, Turned& turned);
    [[nodiscard]] BeamFit fit_of(const HitMap& map, const Turned& turned, double x_m, double y_m) const;

    HillClimbSettings settings_;
    Turned straight_, left_, right_;
};

/// The end points of a scan at a pose, in the world.
template <typename Visit>
void for_each_end(std::span<const Point2> ends, const Pose2& world_from_laser, Visit&& visit) {
    const double c = std::cos(world_from_laser.theta_rad);
    const double s = std::sin(world_from_laser.theta_rad);
    for (const Point2& end : ends) {
        visit(Point2{world_from_laser.x_m + (c * end.x_m - s * end.y_m),
                     world_from_laser.y_m + (s * end.x_m + c * end.y_m)});
    }
}

}  // namespace ddtool
