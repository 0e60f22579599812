#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "check/openness.hpp"
#include "ddtool/filter/update.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool::check {

/// How the motions that matching found between updates agree with those that the odometry reports.
struct MotionEvidence {
    std::uint64_t updates = 0;  ///< that have a motion, so without the first
    double odometry_m = 0.0;    ///< sum of the distances between updates
    double matched_m = 0.0;
    double odometry_turn_rad = 0.0;  ///< sum of the turns' magnitudes, without those of a robot that drives straight
    double along = 1.0;              ///< matched distance for each metre of odometry, in its direction (regression)
    double across = 0.0;        ///< the same across it, to the left: where it is not 0, the laser is yawed on the robot
    double turn = 1.0;          ///< matched turn for each radian of odometry (regression)
    Point2 lever_m;             ///< the point of the robot that stands still where the odometry turns in place
    double usual_m = 0.0;       ///< median difference of the two motions at an update
    std::uint64_t jumps = 0;    ///< updates at which the two differ by more than wheels err
    double worst_jump_m = 0.0;  ///< largest difference
    double worst_jump_rad = 0.0;
    double score = 0.0;           ///< mean score of the matches, 0..1
    double usual_score = 0.0;     ///< median score of those whose scan sees surfaces
    std::uint64_t unmatched = 0;  ///< updates whose scan fits the map nowhere, though it sees surfaces

    /// Where two updates in a row fit the map worst, of those in which the robot came farther by its odometry than the
    /// wide search of a match looks to one side. Nothing but the odometry joins the map before it to the map after it.
    struct Seam {
        double score = 1.0;          ///< the higher of the two; 1 if there was no such place
        double best_particle = 1.0;  ///< the same of the particle that fits best, which need not be the likeliest
        double s = 0.0;              ///< when, in seconds since the first update
        double moved_m = 0.0;
        double turned_rad = 0.0;
        /// Shares of the usual score below which a pair fits badly, for the likeliest particle and for any.
        static constexpr double least_score = 1.0 / 2.0;
        static constexpr double least_best_particle = 2.0 / 3.0;
        /// How far the scores lie below what these shares of a full score would be: the larger the worse.
        [[nodiscard]] double misfit() const {
            return -std::max(score / least_score, best_particle / least_best_particle);
        }
    } seam;

    /// Poor wheels err by so much of the way.
    static constexpr double wheels_share = 0.05;

    /// Where the scans leave open how far the robot came, as along a bare corridor.
    struct Open {
        double odometry_m = 0.0;
        double matched_m = 0.0;  ///< along the odometry's direction
        /// The worst difference on one stretch that is open throughout, by how far it is above wheels_share of the
        /// length beside it.
        double worst_stretch_m = 0.0;
        /// The odometry's length up to there since the scans last told the position for a while: what wheels erred in
        /// it may be put right on a short stretch, where the end of a corridor comes into sight.
        double worst_length_m = 0.0;
        std::uint64_t worst_updates = 0;    ///< the number of updates of that stretch up to there
        double worst_step_m = 0.0;          ///< the largest difference at a single update between walls
        double worst_blind_turn_rad = 0.0;  ///< the largest difference of the turns where the scans see hardly anything
        double worst_blind_m = 0.0;         ///< the odometry's length of that stretch up to there
    } open;
};

/// Gathers MotionEvidence while a run goes on.
class MotionWitness {
public:
    /// `openness`: that of the update's scan along the motion that led to it.
    void add(const Update& update, Openness openness);
    [[nodiscard]] MotionEvidence evidence() const;

private:
    /// The scores of the likeliest particle and of the one that fits best.
    struct Fit {
        double score = 1.0;
        double best_particle = 1.0;
    };
    void add_fit(const Update& update, const Fit& fit, bool sees_surfaces);
    void add_blind(double odometry_m, double turn_rad);
    void add_open(double odometry_m, double along_m, bool between_walls);

    static constexpr double step_of_differences_m = 0.005;
    std::array<std::uint32_t, 400> differences_{};  ///< a histogram; the last bin takes all that are larger

    static constexpr double step_of_scores = 0.005;
    std::array<std::uint32_t, 201> score_counts_{};  ///< a histogram, of scans that see surfaces

    MotionEvidence sums_;
    std::int64_t first_stamp_ns_ = 0;
    std::optional<Fit> fit_before_;  ///< of the update before, if that saw surfaces
    Pose2 odometry_before_;          ///< its motion by the odometry
    Openness before_ = Openness::held;
    double stretch_m_ = 0.0;
    double open_length_m_ = 0.0;  ///< since the scans last told the position for a while
    double held_length_m_ = 0.0;  ///< of the present stretch in which they do
    double worst_excess_m_ = 0.0;
    std::uint64_t stretch_updates_ = 0;
    double blind_turn_rad_ = 0.0;
    double blind_length_m_ = 0.0;
    double dot_ = 0.0, cross_ = 0.0, squares_ = 0.0;
    double turn_dot_ = 0.0, turn_squares_ = 0.0;
    Point2 lever_;
    double scores_ = 0.0;
};

}  // namespace ddtool::check
