#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/filter/path_record.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/filter/scan_noise.hpp"
#include "ddtool/filter/strategies.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

struct RbpfSettings {
    std::size_t particles = 30;
    std::uint64_t seed = 1;
    double update_distance_m = 0.1;  ///< the filter updates after this much odometry motion
    double update_turn_rad = 0.1;    ///< or this much turning
    double resample_share = 0.3;     ///< resample when the effective sample size falls below this share of particles
    /// Exponent on the scan's likelihood. The errors of neighbouring beams and of successive scans are correlated, so
    /// the product of their likelihoods alone would be too confident.
    double likelihood_gain = 0.05;
    /// The exponent holds for scans that usually lie within this standard deviation of the map; that of noisier ones is
    /// lower (ScanNoise::weight()). 0: one exponent for all.
    double full_weight_sd_m = 0.02;
    /// A scan is entered into the maps after this much motion or turning since the last scan that was entered.
    double insert_distance_m = 0.3;
    double insert_turn_rad = 0.3;
    MotionNoise motion;
    OccupancySettings grid;
    ScanPointsSettings points;
    ScanMatcherSettings matcher;
};

/// A hypothesis: a path and the map that belongs to it.
struct Particle {
    Pose2 pose;              ///< world_from_robot
    Pose2 pose_before;       ///< world_from_robot at the previous update
    Pose2 predicted_motion;  ///< since the previous update, in the robot's frame at it, sampled from the motion model
    Pose2 matched_motion;    ///< the same after scan matching and corrections
    Pose2 match_start;       ///< world_from_robot, where scan matching began
    PosePrior match_prior;   ///< uncertainty about match_start that the match was made with
    ScanMatch match;
    double log_likelihood = 0.0;  ///< since the last resampling; the weight is proportional to exp(gain() * this)
    PathRecord::Node past = PoseHistory::none;
    OccupancyGrid grid;
    /// Covariance of the pose relative to the particle's map (x, y, theta in the world; m^2, m rad, rad^2).
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// A place where the robot may be in a known map.
struct Hypothesis {
    Pose2 pose;                                            ///< map_from_robot
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of pose (x, y, theta in the map; m^2, m rad, rad^2)
    double log_weight = 0.0;                               ///< natural logarithm, relative to the others
};

/// Rao-Blackwellised particle filter with one grid map per particle (Grisetti, Stachniss, Burgard, "Improved techniques
/// for grid mapping with Rao-Blackwellized particle filters", IEEE T-RO 2007; Thrun, Burgard, Fox, "Probabilistic
/// robotics", 2005, table 13.4). Inside, the work of an update is spread over the threads of the pool. The same seed
/// gives the same results, byte for byte, with any number of threads.
///
/// In a known map it localises: all particles share that map, and no scan enters it. What a particle does not know of
/// its pose is then relative to a map that stays, so that its whole covariance, and not the noise of the last step
/// alone, is the prior of the match and what the corrections weigh the match against. Along a corridor the covariance
/// grows, and the next thing that holds the robot along it takes it back.
class Rbpf : public ParticleFilter {
public:
    /// `threads` must outlive the filter.
    Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies = {});
    /// Localises in `known_map`, whose cells must be of the size that the settings say. place() must be called before
    /// the first update.
    Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies,
         std::shared_ptr<const OccupancyGrid> known_map);

    /// In a known map: adds a particle at each hypothesis, which is a pose at the last update, or before the first one
    /// at the first frame. The present particles keep together the share kept_share of the weight, where the weights of
    /// the hypotheses sum to the rest. With 0 they are dropped, there must be a hypothesis, and hypotheses are poses at
    /// the next frame, which makes an update even if the robot stands. The new particles have the past of the best one.
    /// Needs a likelihood_gain above 0.
    void place(std::span<const Hypothesis> hypotheses, double kept_share);
    /// From now on each particle has the known map as its own, and scans enter it.
    void map_on();

    std::optional<Update> update(const SensorFrame& frame) override;

    /// The present hypotheses, after any resampling.
    [[nodiscard]] std::span<const Particle> particles() const { return particles_; }
    /// The points of the scan of the last update, in the robot's frame.
    [[nodiscard]] const ScanPoints& points() const { return points_; }
    /// The particle with the largest likelihood since the last resampling; in a known map, of those at the place where
    /// the particles weigh most together. Needs an update or place() before it.
    [[nodiscard]] const Particle& best() const { return particles_[best_]; }
    [[nodiscard]] const OccupancyGrid& map() const override { return grid_of(best()); }
    [[nodiscard]] Pose2 pose() const override;
    [[nodiscard]] Eigen::Matrix3d pose_covariance() const override;
    void visit_trajectory(const PoseVisitor& visit) const override;
    [[nodiscard]] std::optional<OdometryState> odometry_state() const override { return odometry_->state(); }

private:
    /// The motion since the last update.
    struct Step {
        Pose2 odometry_motion;
        double duration_s = 0.0;
        Pose2 expected_motion;  ///< according to the odometry model
        MotionSigmas sigmas;    ///< of expected_motion, according to the odometry model
        PosePrior prior;        ///< of the pose about a sampled prediction
        /// How much of this scan's match the one before has not told already: known maps have errors, and scans that
        /// see the same part of one share them.
        double independent_share = 1.0;
    };
    struct PreparedScan {
        ScanPoints points;
        MatchPoints match_points;
    };
    /// Working memory of one thread.
    struct Worker {
        ScanMatcher matcher;
        ScanInserter inserter;
    };

    [[nodiscard]] const OccupancyGrid& grid_of(const Particle& particle) const {
        return known_map_ ? *known_map_ : particle.grid;
    }
    [[nodiscard]] Pose2 match_start(const Particle& particle, std::size_t index) const;
    [[nodiscard]] PosePrior prior_of_match(const Particle& particle, const Step& step) const;
    [[nodiscard]] Step step_to(const SensorFrame& frame, const Pose2& odometry_motion, bool first) const;
    [[nodiscard]] PreparedScan prepare(const SensorFrame& frame) const;
    void start(const Pose2& world_from_robot);
    void propagate(const Step& step);
    std::vector<std::size_t> share_matches();
    void match(const PreparedScan& scan, const Step& step);
    void search_widely(const PreparedScan& scan, std::span<const std::size_t> matched);
    void search_widely(const PreparedScan& scan, std::span<const std::size_t> matched, SearchOrder order);
    void reweight();
    void choose_best();
    /// Exponent on the likelihood of a scan of this log.
    [[nodiscard]] double gain() const;
    [[nodiscard]] Degeneracy detect(const ParticleSnapshot& swarm) const;
    void correct(const PreparedScan& scan, const Step& step, const Degeneracy& degeneracy);
    void correct(Particle& particle, const ScanMatch* alike, const PreparedScan& scan, const Step& step,
                 const Degeneracy& degeneracy, ScanMatcher& matcher) const;
    void learn(const PreparedScan& scan, const Step& step);
    bool resample_if_poor(const ParticleSnapshot& swarm);
    void map(const PreparedScan& scan, const Pose2& odom_from_robot);
    void remember(const SensorFrame& frame, const Pose2& odometry_motion);
    [[nodiscard]] ParticleSnapshot snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const;

    RbpfSettings settings_;
    ThreadPool& threads_;
    FilterStrategies strategies_;
    std::shared_ptr<const OccupancyGrid> known_map_;  ///< null where each particle has its own
    std::unique_ptr<OdometryModel> odometry_;
    std::vector<Worker> workers_;
    std::vector<Particle> particles_;
    std::size_t best_ = 0;                 ///< index of best()
    ScanPoints points_;                    ///< of the last update
    std::vector<std::size_t> matched_by_;  ///< for each particle the one whose match it has, most often itself
    PathRecord path_;
    Pose2 odom_at_update_;
    std::int64_t stamp_at_update_ns_ = 0;
    std::optional<Pose2> odom_at_mapping_;  ///< when a scan last entered the maps
    std::uint64_t updates_ = 0;
    bool placed_anew_ = false;                              ///< the particles are at their poses of the next frame
    ScanNoise noise_;                                       ///< with each beam's distance cut off as in the likelihood
    ScanNoise beam_noise_;                                  ///< with each beam's weight in the match
    double usual_score_ = 0.0;                              ///< of the best particle's matches, a running mean
    bool last_fitted_nowhere_ = false;                      ///< the scan of the last update, in any particle's map
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of the pose at the last update
};

}  // namespace ddtool
