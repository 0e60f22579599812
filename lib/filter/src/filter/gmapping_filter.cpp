#include "ddtool/filter/gmapping_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filter/pose_covariance.hpp"
#include "swarm/moments.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

/// Keys of random streams by purpose, so that no two draws share a stream.
enum GmappingDraw : std::uint64_t { gmapping_motion_draw = 1, gmapping_resampling_draw = 2 };

}  // namespace

GmappingFilter::GmappingFilter(const GmappingSettings& settings, ThreadPool& threads, GmappingStrategies strategies)
    : settings_(settings), threads_(threads), strategies_(std::move(strategies)) {
    if (!strategies_.resampling) {
        strategies_.resampling = std::make_shared<SystematicResampling>();
    }
    for (std::size_t worker = 0; worker < threads_.size(); ++worker) {
        workers_.push_back({HillClimb(settings_.matcher), ScanInserter()});
    }
}

std::optional<Update> GmappingFilter::update(const SensorFrame& frame) {
    Update update;
    StageTimes& times = update.times;
    const Beams beams = timed(times.prepare_s, [&] { return beams_of(frame); });
    const bool first = particles_.empty();
    const Pose2 odom_from_laser = frame.odom_from_robot * beams.robot_from_laser;
    if (first) {
        start(odom_from_laser);
        odom_from_laser_ = odom_from_laser;
        odom_at_update_ = frame.odom_from_robot;
    }
    robot_from_laser_ = beams.robot_from_laser;
    timed(times.match_s, [&] { propagate(odom_from_laser); });
    const Pose2 odometry_motion = between(odom_at_update_, frame.odom_from_robot);
    if (!first && motion_share() < 1.0) {
        path_.add_scan(frame.scan.stamp_ns, odometry_motion, motion_share());
        return std::nullopt;
    }
    if (!first) {
        timed(times.match_s, [&] { match(beams); });
    }
    update.matched = snapshot(frame, odometry_motion);
    if (!first && strategies_.detector) {
        update.degeneracy = timed(times.detect_s, [&] { return strategies_.detector(update.matched); });
    }
    update.corrected = update.matched;
    if (!first && strategies_.failed_match) {
        timed(times.correct_s, [&] {
            rescue_failed(beams, update.degeneracy.degree);
            update.corrected = snapshot(frame, odometry_motion);
        });
    }
    update.pose = best().pose * inverse(robot_from_laser_);
    update.covariance = covariance_ = pose_scatter(update.matched.particles, update.pose);
    update.resampled = !first && timed(times.resample_s, [&] { return resample_if_poor(update.corrected.particles); });
    timed(times.map_s, [&] { map_scan(beams, scan_points(frame, settings_.points)); });
    remember(frame, odometry_motion);
    return update;
}

/// Beams without return, failed ones and those beyond the usable range are left out. GMapping does the same, except
/// that it counts a failed one as a miss, which shifts all weights alike.
GmappingFilter::Beams GmappingFilter::beams_of(const SensorFrame& frame) const {
    const LaserScan& scan = frame.scan;
    const double own_m = scan.range_max_m - GmappingSettings::range_margin_m;
    const double usable_m = settings_.usable_range_m > 0.0 ? std::min(settings_.usable_range_m, own_m) : own_m;
    const double middle_rad =
        0.5 * (scan.angle_rad(0) + scan.angle_rad(std::max<std::size_t>(scan.ranges_m.size(), 1) - 1));
    Beams beams{.robot_from_laser = frame.robot_from_laser * Pose2{0.0, 0.0, middle_rad}, .ends = {}};
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        const auto range_m = static_cast<double>(scan.ranges_m[beam]);
        beams.measured += std::isnan(range_m) ? 0 : 1;
        if (range_m <= usable_m) {
            const double angle_rad = scan.angle_rad(beam) - middle_rad;
            beams.ends.push_back({range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)});
            beams.reach_m = std::max(beams.reach_m, range_m);
        }
    }
    return beams;
}

void GmappingFilter::start(const Pose2& world_from_laser) {
    particles_.assign(settings_.particles, GmappingParticle{.pose = world_from_laser,
                                                            .pose_before = world_from_laser,
                                                            .predicted = world_from_laser,
                                                            .fit = {},
                                                            .hits = HitMap(settings_.grid.cell_size_m),
                                                            .grid = OccupancyGrid(settings_.grid)});
}

/// Every scan moves the particles by its own motion with noise of its own, updates or not.
void GmappingFilter::propagate(const Pose2& odom_from_laser) {
    const Pose2 motion = between(odom_from_laser_, odom_from_laser);
    const MotionSigmas sigmas = motion_sigmas(motion, settings_.motion);
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        RandomStream random({settings_.seed, gmapping_motion_draw, scans_, index});
        particles_[index].pose = particles_[index].pose * sample_motion(motion, sigmas, random);
    }
    way_m_ += std::hypot(motion.x_m, motion.y_m);
    turned_rad_ += std::abs(motion.theta_rad);
    variance_since_update_ += Eigen::Vector3d(sigmas.x_m, sigmas.y_m, sigmas.theta_rad).cwiseAbs2();
    odom_from_laser_ = odom_from_laser;
    ++scans_;
}

/// The motion since the last update as a share of that which triggers one; from 1 on an update is due.
double GmappingFilter::motion_share() const {
    return std::max(way_m_ / settings_.update_distance_m, turned_rad_ / settings_.update_turn_rad);
}

void GmappingFilter::match(const Beams& beams) {
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        GmappingParticle& particle = particles_[index];
        HillClimb& matcher = workers_[worker].matcher;
        particle.predicted = particle.pose;
        const HillClimb::Found found = matcher.climb(particle.hits, beams.ends, particle.pose);
        const bool accepted = found.fit.score > settings_.least_score;
        particle.pose = accepted ? found.pose : particle.pose;
        particle.fit = accepted ? found.fit : matcher.fit(particle.hits, beams.ends, particle.pose);
        particle.log_likelihood += particle.fit.log_likelihood;
        particle.life_log_likelihood += particle.fit.log_likelihood;
    });
}

void GmappingFilter::rescue_failed(const Beams& beams, double degree) {
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        GmappingParticle& particle = particles_[index];
        const HillClimb::Found found =
            rescued(*strategies_.failed_match, workers_[worker].matcher, particle.hits, beams.ends, beams.measured,
                    {particle.pose, particle.fit}, particle.predicted, degree);
        const double gained = found.fit.log_likelihood - particle.fit.log_likelihood;
        particle.pose = found.pose;
        particle.fit = found.fit;
        particle.log_likelihood += gained;
        particle.life_log_likelihood += gained;
    });
}

bool GmappingFilter::resample_if_poor(std::span<const SnapshotParticle> swarm) {
    if (effective_sample_size(weights_of(swarm)) >= settings_.resample_share * static_cast<double>(particles_.size())) {
        return false;
    }
    RandomStream random({settings_.seed, gmapping_resampling_draw, updates_});
    std::vector<GmappingParticle> next;
    next.reserve(particles_.size());
    for (const Descendant& descendant : strategies_.resampling->resample(swarm, random)) {
        next.push_back(particles_[descendant.parent]);
        next.back().log_likelihood = 0.0;
        if (descendant.pose != swarm[descendant.parent].pose) {
            next.back().pose = descendant.pose * robot_from_laser_;
        }
        path_.acquire(next.back().past);
    }
    for (const GmappingParticle& particle : particles_) {
        path_.release(particle.past);
    }
    particles_ = std::move(next);
    return true;
}

/// Every update enters its scan. The grid comes first, because it has the limits on the size of a map.
void GmappingFilter::map_scan(const Beams& beams, const ScanPoints& points) {
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        GmappingParticle& particle = particles_[index];
        const Pose2& pose = particle.pose;
        workers_[worker].inserter.insert(particle.grid, points, pose * inverse(beams.robot_from_laser));
        particle.hits.reserve({pose.x_m - beams.reach_m, pose.y_m - beams.reach_m},
                              {pose.x_m + beams.reach_m, pose.y_m + beams.reach_m});
        for_each_end(beams.ends, pose, [&](const Point2& end) { particle.hits.add(end); });
    });
}

void GmappingFilter::remember(const SensorFrame& frame, const Pose2& odometry_motion) {
    path_.add_update(frame.scan.stamp_ns, odometry_motion);
    std::vector<PathRecord::Node> pasts;
    for (GmappingParticle& particle : particles_) {
        particle.past = path_.extend(particle.past, particle.pose * inverse(robot_from_laser_));
        pasts.push_back(particle.past);
        particle.pose_before = particle.pose;
    }
    path_.settle(pasts);
    odom_at_update_ = frame.odom_from_robot;
    way_m_ = 0.0;
    turned_rad_ = 0.0;
    variance_since_update_.setZero();
    ++updates_;
}

ParticleSnapshot GmappingFilter::snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const {
    const double gain = 1.0 / (settings_.likelihood_smoothing * static_cast<double>(particles_.size()));
    std::vector<double> log_weights;
    for (const GmappingParticle& particle : particles_) {
        log_weights.push_back(gain * particle.log_likelihood);
    }
    const std::vector<double> weights = normalised_weights(log_weights);
    ParticleSnapshot swarm{
        .stamp_ns = frame.scan.stamp_ns, .update = updates_, .odometry_motion = odometry_motion, .particles = {}};
    const Pose2 laser_from_robot = inverse(robot_from_laser_);
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        const GmappingParticle& particle = particles_[index];
        const Pose2 before = particle.pose_before * laser_from_robot;
        const Pose2 pose = particle.pose * laser_from_robot;
        swarm.particles.push_back({.pose = pose,
                                   .matched_motion = between(before, pose),
                                   .predicted_motion = between(before, particle.predicted * laser_from_robot),
                                   .log_likelihood = particle.log_likelihood,
                                   .log_likelihood_increment = particle.fit.log_likelihood,
                                   .match_score = particle.fit.mean_score(),
                                   .weight = weights[index]});
    }
    return swarm;
}

const GmappingParticle& GmappingFilter::best() const {
    return *std::max_element(particles_.begin(), particles_.end(),
                             [](const GmappingParticle& a, const GmappingParticle& b) {
                                 return a.life_log_likelihood < b.life_log_likelihood;
                             });
}

/// Between updates this is the pose at the last update moved by the odometry alone, as slam_gmapping publishes it.
Pose2 GmappingFilter::pose() const {
    return best().pose_before * inverse(robot_from_laser_) * path_.motion_since_update();
}

Eigen::Matrix3d GmappingFilter::pose_covariance() const {
    const Eigen::Vector3d sigmas = variance_since_update_.cwiseSqrt();
    const Pose2& motion = path_.motion_since_update();
    if (motion == Pose2{}) {
        return covariance_;
    }
    return predicted_covariance(covariance_, best().pose_before * inverse(robot_from_laser_), motion,
                                {sigmas.x(), sigmas.y(), sigmas.z()});
}

void GmappingFilter::visit_trajectory(const PoseVisitor& visit) const {
    if (!particles_.empty()) {
        path_.visit_trajectory(best().past, visit);
    }
}

}  // namespace ddtool
