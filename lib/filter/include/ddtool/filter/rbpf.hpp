#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/pose_history.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/filter/stage_times.hpp"
#include "ddtool/filter/strategies.hpp"
#include "ddtool/filter/update_report.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/swarm/motion_model.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

struct RbpfSettings {
    std::size_t particles = 30;
    std::uint64_t seed = 1;
    double update_distance_m = 0.1;  ///< the filter updates after this much odometry motion
    double update_turn_rad = 0.1;    ///< or this much turning
    double resample_share = 0.3;     ///< resample when the effective sample size falls below this share of particles
    /// Exponent on the scan's likelihood: neighbouring beams and scans err together, so their product is too sure.
    double likelihood_gain = 0.05;
    /// A match with a lower mean beam score is no match: the particle keeps its predicted pose.
    double min_match_score = 0.1;
    /// Scans enter the map after this much motion or turning since the last that did.
    double insert_distance_m = 0.3;
    double insert_turn_rad = 0.3;
    MotionNoise motion;
    OccupancySettings grid;
    ScanPointsSettings points;
    ScanMatcherSettings matcher;
};

struct Particle {
    Pose2 pose;  ///< world_from_robot
    Pose2 predicted_motion;
    Pose2 matched_motion;
    ScanMatch match;
    double log_likelihood = 0.0;  ///< since the last resampling; the weight is its exponential, after the gain
    PoseHistory::Node history = PoseHistory::none;
    OccupancyGrid grid;
    /// Of the pose relative to the particle's map (x, y, theta in the world).
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Rao-Blackwellised particle filter with one grid map a particle (Grisetti, Stachniss, Burgard, "Improved techniques
/// for grid mapping with Rao-Blackwellized particle filters", IEEE T-RO 2007). The same seed gives the same bytes on
/// any number of threads.
class Rbpf {
public:
    using SnapshotSink = std::function<void(const ParticleSnapshot&, const Degeneracy&)>;

    Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies = {});

    /// Called with every snapshot, before resampling.
    void on_snapshot(SnapshotSink sink) { sink_ = std::move(sink); }

    /// Takes the next scan; true if it moved the filter, false if the robot has hardly moved since the last update.
    bool process(const SensorFrame& frame);

    [[nodiscard]] std::span<const Particle> particles() const { return particles_; }
    /// The particle of the largest likelihood since the last resampling.
    [[nodiscard]] const Particle& best() const;
    /// world_from_robot at the latest scan, by the best particle.
    [[nodiscard]] Pose2 pose() const;
    /// Of pose() (x, y, theta in the world): that of the last update, and what the odometry since may be wrong by.
    [[nodiscard]] Eigen::Matrix3d pose_covariance() const;
    /// A pose for every scan so far, from the history of the best particle.
    [[nodiscard]] Trajectory trajectory() const;
    /// Of the last update but the first, which has nothing to report.
    [[nodiscard]] const UpdateReport& last_report() const { return last_report_; }
    [[nodiscard]] std::uint64_t updates() const { return updates_; }
    [[nodiscard]] std::uint64_t resamplings() const { return resamplings_; }
    [[nodiscard]] const StageTimes& times() const { return times_; }

private:
    struct ScanRecord {
        std::int64_t stamp_ns = 0;
        std::uint64_t update = 0;  ///< the last update at or before the scan
        Pose2 motion;              ///< odometry since that update, in the robot's frame there
        double share = 0.0;        ///< of the way to the next update
    };
    /// The way since the last update.
    struct Step {
        Pose2 odometry_motion;
        double duration_s = 0.0;
        Pose2 expected_motion;  ///< by the odometry model
    };
    struct Worker {
        ScanMatcher matcher;
        ScanInserter inserter;
    };

    void start(const SensorFrame& frame);
    void update(const SensorFrame& frame, const Step& step);
    [[nodiscard]] Step step_to(const SensorFrame& frame, const Pose2& odometry_motion) const;
    void predict_and_match(const MatchPoints& points, const Step& step);
    [[nodiscard]] ParticleSnapshot snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const;
    void correct(const MatchPoints& points, const Step& step, const Degeneracy& degeneracy);
    void correct_covariances();
    void learn_odometry(const Step& step);
    void settle(Particle& particle, const Pose2& from, const MatchPoints& points, ScanMatcher& matcher,
                const ScanMatch& match, const Pose2& predicted) const;
    bool resample_if_poor(const ParticleSnapshot& swarm, const Degeneracy& degeneracy);
    void insert_scan(const ScanPoints& points, const Pose2& odom_from_robot);
    void remember();
    void settle_past();
    [[nodiscard]] StampedPose pose_of(const ScanRecord& scan, const std::vector<Pose2>& poses) const;

    RbpfSettings settings_;
    ThreadPool& threads_;
    FilterStrategies strategies_;
    SnapshotSink sink_;
    std::vector<Worker> workers_;
    std::vector<Particle> particles_;
    PoseHistory history_;
    std::deque<StampedPose> settled_;     ///< scans of the past that all particles share; a deque grows without copies
    std::uint64_t first_update_ = 0;      ///< the first that is not settled, where history_ begins
    std::deque<ScanRecord> scans_;        ///< since that update
    std::deque<Pose2> odometry_motions_;  ///< odometry motion before it and each update since
    Pose2 odom_at_update_;
    std::int64_t stamp_at_update_ns_ = 0;
    Pose2 odom_at_insertion_;
    std::uint64_t updates_ = 0;
    std::uint64_t resamplings_ = 0;
    UpdateReport last_report_;
    StageTimes times_;
};

}  // namespace ddtool
