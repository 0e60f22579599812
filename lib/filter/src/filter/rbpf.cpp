#include "ddtool/filter/rbpf.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "filter/pose_covariance.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

/// Purposes of random streams, so that no two draws share one.
enum Purpose : std::uint64_t { motion_draw = 1, resampling_draw = 2 };

/// How far the robot moved, in update thresholds.
double motion_share(const Pose2& motion, const RbpfSettings& settings) {
    return std::max(std::hypot(motion.x_m, motion.y_m) / settings.update_distance_m,
                    std::abs(motion.theta_rad) / settings.update_turn_rad);
}

/// No particle's past is settled nearer than this to the present; odometry is learnt over some dozens.
constexpr std::uint64_t kept_updates = 1024;

/// A pause in a log is no time in which a gyro drifted.
constexpr double longest_step_s = 2.0;

Eigen::Matrix3d in_robot_frame(const Eigen::Matrix3d& information, double theta_rad) {
    Eigen::Matrix3d world_from_robot = Eigen::Matrix3d::Identity();
    world_from_robot.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(theta_rad).toRotationMatrix();
    return world_from_robot.transpose() * information * world_from_robot;
}

PosePrior prior_of(const Pose2& odometry_motion, const RbpfSettings& settings) {
    constexpr double least_m = 0.005;
    constexpr double least_rad = 0.002;
    const MotionSigmas sigmas = motion_sigmas(odometry_motion, settings.motion);
    return {sigmas.x_m + least_m, sigmas.y_m + least_m, sigmas.theta_rad + least_rad};
}

}  // namespace

Rbpf::Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies)
    : settings_(settings), threads_(threads), strategies_(std::move(strategies)) {
    if (!strategies_.resampling) {
        strategies_.resampling = std::make_shared<SystematicResampling>();
    }
    if (!strategies_.odometry) {
        strategies_.odometry = std::make_shared<FixedOdometry>(settings_.motion);
    }
    for (std::size_t worker = 0; worker < threads_.size(); ++worker) {
        workers_.push_back({ScanMatcher(settings_.matcher, settings_.grid.cell_size_m), ScanInserter()});
    }
}

bool Rbpf::process(const SensorFrame& frame) {
    const bool first = particles_.empty();
    const Pose2 motion = first ? Pose2{} : between(odom_at_update_, frame.odom_from_robot);
    const double share = motion_share(motion, settings_);
    const bool moved = first || share >= 1.0;
    if (first) {
        start(frame);
    } else if (moved) {
        update(frame, step_to(frame, motion));
    }
    if (moved) {
        odom_at_update_ = frame.odom_from_robot;
        stamp_at_update_ns_ = frame.scan.stamp_ns;
        odometry_motions_.push_back(motion);
        ++updates_;
    }
    scans_.push_back({frame.scan.stamp_ns, updates_ - 1, moved ? Pose2{} : motion, moved ? 0.0 : share});
    if (moved && updates_ % kept_updates == 0) {
        settle_past();
    }
    return moved;
}

void Rbpf::start(const SensorFrame& frame) {
    const Particle first{.pose = frame.odom_from_robot,
                         .predicted_motion = {},
                         .matched_motion = {},
                         .match = {},
                         .history = PoseHistory::none,
                         .grid = OccupancyGrid(settings_.grid)};
    particles_.assign(settings_.particles, first);
    insert_scan(scan_points(frame, settings_.points), frame.odom_from_robot);
    remember();
}

Rbpf::Step Rbpf::step_to(const SensorFrame& frame, const Pose2& odometry_motion) const {
    const double elapsed_s = 1e-9 * static_cast<double>(frame.scan.stamp_ns - stamp_at_update_ns_);
    const double duration_s = std::clamp(elapsed_s, 0.0, longest_step_s);
    return {odometry_motion, duration_s, strategies_.odometry->expected(odometry_motion, duration_s)};
}

void Rbpf::update(const SensorFrame& frame, const Step& step) {
    ScanPoints points;
    MatchPoints match_points;
    {
        const StageTimer timer(times_.prepare_s);
        points = scan_points(frame, settings_.points);
        match_points = MatchPoints(points, settings_.grid.cell_size_m);
    }
    predict_and_match(match_points, step);
    ParticleSnapshot swarm = snapshot(frame, step.odometry_motion);
    Degeneracy degeneracy;
    if (strategies_.detector) {
        const StageTimer timer(times_.detect_s);
        degeneracy = strategies_.detector(swarm);
    }
    if (sink_) {
        sink_(swarm, degeneracy);
    }
    last_report_ = report_of(swarm, degeneracy);
    if (!strategies_.corrections.empty()) {
        correct(match_points, step, degeneracy);
        const ParticleSnapshot matched = std::exchange(swarm, snapshot(frame, step.odometry_motion));
        last_report_.corrected_m = mean_distance_m(matched, swarm);
    }
    correct_covariances();
    learn_odometry(step);
    last_report_.pose = best().pose;
    last_report_.covariance = best().covariance + pose_scatter(swarm, best().pose);
    last_report_.resampled = resample_if_poor(swarm, degeneracy);
    const Pose2 since = between(odom_at_insertion_, frame.odom_from_robot);
    if (std::hypot(since.x_m, since.y_m) >= settings_.insert_distance_m ||
        std::abs(since.theta_rad) >= settings_.insert_turn_rad) {
        insert_scan(points, frame.odom_from_robot);
    }
    remember();
}

void Rbpf::predict_and_match(const MatchPoints& points, const Step& step) {
    const StageTimer timer(times_.match_s);
    const PosePrior prior = prior_of(step.expected_motion, settings_);
    const MotionSigmas sigmas = strategies_.odometry->sigmas(step.odometry_motion, step.duration_s);
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        Particle& particle = particles_[index];
        ScanMatcher& matcher = workers_[worker].matcher;
        RandomStream random({settings_.seed, motion_draw, updates_, index});
        particle.predicted_motion = sample_motion(step.expected_motion, settings_.motion, random);
        const Pose2 from = particle.pose;
        const Pose2 predicted = from * particle.predicted_motion;
        particle.covariance = predicted_covariance(particle.covariance, from, step.expected_motion, sigmas);
        settle(particle, from, points, matcher, matcher.match(particle.grid, points, predicted, prior), predicted);
        particle.log_likelihood += particle.match.log_likelihood;
    });
}

/// Takes a match for the particle's pose, or the prediction where the match is none.
void Rbpf::settle(Particle& particle, const Pose2& from, const MatchPoints& points, ScanMatcher& matcher,
                  const ScanMatch& match, const Pose2& predicted) const {
    particle.match =
        match.score < settings_.min_match_score ? matcher.evaluate(particle.grid, points, predicted) : match;
    particle.pose = particle.match.pose;
    particle.matched_motion = between(from, particle.pose);
}

ParticleSnapshot Rbpf::snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const {
    std::vector<double> log_weights;
    for (const Particle& particle : particles_) {
        log_weights.push_back(settings_.likelihood_gain * particle.log_likelihood);
    }
    const std::vector<double> weights = normalised_weights(log_weights);
    ParticleSnapshot swarm{frame.scan.stamp_ns, updates_, odometry_motion, {}};
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        const Particle& particle = particles_[index];
        swarm.particles.push_back({particle.pose, particle.matched_motion, particle.predicted_motion,
                                   particle.log_likelihood, particle.match.log_likelihood, particle.match.score,
                                   weights[index]});
    }
    return swarm;
}

void Rbpf::correct(const MatchPoints& points, const Step& step, const Degeneracy& degeneracy) {
    const StageTimer timer(times_.correct_s);
    const MotionSigmas sigmas = strategies_.odometry->sigmas(step.odometry_motion, step.duration_s);
    const PosePrior prior = prior_of(step.expected_motion, settings_);
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        Particle& particle = particles_[index];
        ScanMatcher& matcher = workers_[worker].matcher;
        const Pose2 from = particle.pose * inverse(particle.matched_motion);
        const MatchContext context{
            matcher,
            particle.grid,
            points,
            from * particle.predicted_motion,
            prior,
            from * step.expected_motion,
            predicted_covariance(Eigen::Matrix3d::Zero(), from, step.expected_motion, sigmas).inverse(),
            settings_.min_match_score};
        const double before = particle.match.log_likelihood;
        for (const auto& correction : strategies_.corrections) {
            particle.match = correction->correct(context, particle.match, degeneracy);
        }
        particle.pose = particle.match.pose;
        particle.matched_motion = between(from, particle.pose);
        particle.log_likelihood += particle.match.log_likelihood - before;
    });
}

/// How sure each particle is of its pose, now that the scan has been matched.
void Rbpf::correct_covariances() {
    for (Particle& particle : particles_) {
        particle.covariance = corrected_covariance(particle.covariance, particle.match.information);
    }
}

void Rbpf::learn_odometry(const Step& step) {
    const Particle& particle = best();
    const auto pose_before = [&](std::size_t updates) {
        return updates == 0 ? particle.pose : history_.pose_before(particle.history, updates - 1);
    };
    strategies_.odometry->learn({step.odometry_motion, step.duration_s,
                                 in_robot_frame(particle.match.information, particle.pose.theta_rad), pose_before});
}

bool Rbpf::resample_if_poor(const ParticleSnapshot& swarm, const Degeneracy& degeneracy) {
    const StageTimer timer(times_.resample_s);
    if (effective_sample_size(weights_of(swarm.particles)) >=
        settings_.resample_share * static_cast<double>(particles_.size())) {
        return false;
    }
    RandomStream random({settings_.seed, resampling_draw, updates_});
    std::vector<Particle> next;
    next.reserve(particles_.size());
    for (const Descendant& descendant : strategies_.resampling->resample(swarm.particles, degeneracy, random)) {
        next.push_back(particles_[descendant.parent]);
        next.back().pose = descendant.pose;
        next.back().log_likelihood = 0.0;
        history_.acquire(next.back().history);
    }
    for (const Particle& particle : particles_) {
        history_.release(particle.history);
    }
    particles_ = std::move(next);
    ++resamplings_;
    return true;
}

void Rbpf::insert_scan(const ScanPoints& points, const Pose2& odom_from_robot) {
    const StageTimer timer(times_.map_s);
    odom_at_insertion_ = odom_from_robot;
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        workers_[worker].inserter.insert(particles_[index].grid, points, particles_[index].pose);
    });
}

void Rbpf::remember() {
    for (Particle& particle : particles_) {
        const PoseHistory::Node parent = particle.history;
        particle.history = history_.add(parent, particle.pose);
        history_.release(parent);
    }
}

const Particle& Rbpf::best() const {
    return *std::max_element(particles_.begin(), particles_.end(),
                             [](const Particle& a, const Particle& b) { return a.log_likelihood < b.log_likelihood; });
}

Pose2 Rbpf::pose() const { return best().pose * scans_.back().motion; }

Eigen::Matrix3d Rbpf::pose_covariance() const {
    const ScanRecord& scan = scans_.back();
    if (scan.motion == Pose2{}) {
        return last_report_.covariance;
    }
    const double since_s = 1e-9 * static_cast<double>(scan.stamp_ns - stamp_at_update_ns_);
    return predicted_covariance(last_report_.covariance, best().pose, scan.motion,
                                strategies_.odometry->sigmas(scan.motion, std::clamp(since_s, 0.0, longest_step_s)));
}

Trajectory Rbpf::trajectory() const {
    if (particles_.empty()) {
        return {};
    }
    const std::vector<Pose2> poses = history_.path(best().history);
    Trajectory trajectory(settled_.begin(), settled_.end());
    for (const ScanRecord& scan : scans_) {
        trajectory.push_back(pose_of(scan, poses));
    }
    return trajectory;
}

/// Between two updates the odometry is followed, and what the second update corrected is spread over the way. `poses`
/// are those of the updates from first_update_.
StampedPose Rbpf::pose_of(const ScanRecord& scan, const std::vector<Pose2>& poses) const {
    const std::size_t update = scan.update - first_update_;
    Pose2 correction;
    if (update + 1 < poses.size()) {
        const Pose2 by_odometry = poses[update] * odometry_motions_[update + 1];
        correction = interpolate({}, between(by_odometry, poses[update + 1]), scan.share);
    }
    return {scan.stamp_ns, poses[update] * scan.motion * correction};
}

/// Nothing that is still to come changes the poses before a common ancestor, so a pose a scan is enough of them.
void Rbpf::settle_past() {
    const PoseHistory::Node common = history_.ancestor(particles_.front().history, kept_updates);
    if (!std::all_of(particles_.begin(), particles_.end(), [&](const Particle& particle) {
            return history_.ancestor(particle.history, kept_updates) == common;
        })) {
        return;
    }
    const std::vector<Pose2> poses = history_.path(common);
    const std::size_t updates = poses.size() - 1;
    while (scans_.front().update < first_update_ + updates) {
        settled_.push_back(pose_of(scans_.front(), poses));
        scans_.pop_front();
    }
    odometry_motions_.erase(odometry_motions_.begin(),
                            odometry_motions_.begin() + static_cast<std::ptrdiff_t>(updates));
    history_.forget_before(common);
    first_update_ += updates;
}

}  // namespace ddtool
