#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/failed_match.hpp"
#include "ddtool/filter/hill_climb.hpp"
#include "ddtool/filter/hit_map.hpp"
#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/filter/path_record.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/filter/strategies.hpp"
#include "ddtool/robot/scan_points.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// The defaults are those of slam_gmapping, the ROS node of GMapping.
struct GmappingSettings {
    std::size_t particles = 30;
    std::uint64_t seed = 1;
    double update_distance_m = 1.0;  ///< the filter updates after this much odometry motion, summed over the scans
    double update_turn_rad = 0.5;    ///< or this much turning, summed likewise
    double resample_share = 0.5;     ///< resample when the effective sample size falls below this share of particles
    /// The weights are the likelihoods to the power 1 / (this * particles).
    double likelihood_smoothing = 3.0;
    /// A match whose score is not above this is dropped for the predicted pose.
    double least_score = 0.0;
    /// Longer ranges are left out; 0 stands for the lidar's own range less range_margin_m.
    double usable_range_m = 0.0;
    LinearMotionNoise motion;
    HillClimbSettings matcher;
    OccupancySettings grid;     ///< of the map that is drawn; the map for matching has the same cell size
    ScanPointsSettings points;  ///< of the map that is drawn

    /// As slam_gmapping has it: some drivers report the greatest range where nothing was met.
    static constexpr double range_margin_m = 0.01;
};

/// What is added to GMapping. Where a member is empty, the swarm never counts as degenerate, the match is kept, or
/// resampling is systematic, as in GMapping itself.
struct GmappingStrategies {
    DegeneracyDetector detector;
    std::optional<FailedMatchSettings> failed_match;
    std::shared_ptr<const Resampling> resampling;
};

/// A hypothesis of the GmappingFilter.
struct GmappingParticle {
    Pose2 pose;                        ///< world_from_laser at the latest scan
    Pose2 pose_before;                 ///< world_from_laser at the previous update
    Pose2 predicted;                   ///< world_from_laser at the latest update, before scan matching
    BeamFit fit;                       ///< at the pose after scan matching
    double log_likelihood = 0.0;       ///< since the last resampling
    double life_log_likelihood = 0.0;  ///< since the start; the best particle has the largest
    PathRecord::Node past = PoseHistory::none;
    HitMap hits;         ///< for scan matching
    OccupancyGrid grid;  ///< the map as it is drawn
};

/// OpenSLAM GMapping as its ROS node slam_gmapping runs it, made from its algorithm (Grisetti, Stachniss, Burgard,
/// "Improved techniques for grid mapping with Rao-Blackwellized particle filters", IEEE T-RO 2007). With the same draws
/// it takes the same decisions (docs/filter.md). As there, the particles are hypotheses of the laser's pose, and every
/// scan moves them by its own noisy odometry motion. With strategies it is the paper's method. The same seed gives the
/// same results, byte for byte, with any number of threads.
class GmappingFilter : public ParticleFilter {
public:
    /// `threads` must outlive the filter.
    GmappingFilter(const GmappingSettings& settings, ThreadPool& threads, GmappingStrategies strategies = {});

    std::optional<Update> update(const SensorFrame& frame) override;

    [[nodiscard]] std::span<const GmappingParticle> particles() const { return particles_; }
    [[nodiscard]] const GmappingParticle& best() const;
    [[nodiscard]] const OccupancyGrid& map() const override { return best().grid; }
    [[nodiscard]] Pose2 pose() const override;
    [[nodiscard]] Eigen::Matrix3d pose_covariance() const override;
    void visit_trajectory(const PoseVisitor& visit) const override;

private:
    /// A scan as the filter uses it, with its laser's frame turned so that x points to the middle of the scan.
    struct Beams {
        Pose2 robot_from_laser;
        std::vector<Point2> ends;  ///< end points in the laser's frame
        std::size_t measured = 0;  ///< beams that did not fail, those without return or beyond the usable range, too
        double reach_m = 0.0;      ///< the longest range among them
    };
    /// Working memory of one thread.
    struct Worker {
        HillClimb matcher;
        ScanInserter inserter;
    };

    [[nodiscard]] Beams beams_of(const SensorFrame& frame) const;
    void start(const Pose2& world_from_laser);
    void propagate(const Pose2& odom_from_laser);
    [[nodiscard]] double motion_share() const;
    void match(const Beams& beams);
    void rescue_failed(const Beams& beams, double degree);
    bool resample_if_poor(std::span<const SnapshotParticle> swarm);
    void map_scan(const Beams& beams, const ScanPoints& points);
    void remember(const SensorFrame& frame, const Pose2& odometry_motion);
    [[nodiscard]] ParticleSnapshot snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const;

    GmappingSettings settings_;
    ThreadPool& threads_;
    GmappingStrategies strategies_;
    std::vector<Worker> workers_;
    std::vector<GmappingParticle> particles_;
    PathRecord path_;
    Pose2 robot_from_laser_;  ///< at the latest scan
    Pose2 odom_from_laser_;   ///< at the latest scan
    Pose2 odom_at_update_;    ///< odom_from_robot
    double way_m_ = 0.0;      ///< of the laser since the last update, summed over the scans
    double turned_rad_ = 0.0;
    Eigen::Vector3d variance_since_update_ = Eigen::Vector3d::Zero();  ///< of the motion: x, y, theta
    std::uint64_t scans_ = 0;
    std::uint64_t updates_ = 0;
    Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of the pose at the last update
};

}  // namespace ddtool
