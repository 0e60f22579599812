#include "ddtool/filter/rbpf.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/squared.hpp"
#include "filter/pose_covariance.hpp"
#include "swarm/modes.hpp"
#include "swarm/moments.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

/// Keys of random streams by purpose, so that no two draws share a stream.
enum Purpose : std::uint64_t { motion_draw = 1, resampling_draw = 2, place_draw = 3 };

/// The motion of the robot as a share of the motion that triggers an update; from 1 on an update is due.
double motion_share(const Pose2& motion, const RbpfSettings& settings) {
    return std::max(std::hypot(motion.x_m, motion.y_m) / settings.update_distance_m,
                    std::abs(motion.theta_rad) / settings.update_turn_rad);
}

/// Limit on the duration of a step. A longer time between two stamps is a pause in the log, and the gyro's bias must
/// not be applied to all of it.
constexpr double longest_step_s = 2.0;

double step_duration_s(std::int64_t from_ns, std::int64_t to_ns) {
    return std::clamp(1e-9 * static_cast<double>(to_ns - from_ns), 0.0, longest_step_s);
}

/// A swarm of so many, as mapping has, is matched whole. With fewer matches the robot was lost in a long corridor once
/// in ten drives.
constexpr std::size_t whole_swarm = 30;
/// So many matches are made of a larger swarm in a known map, and at least one in each neighbourhood: on average one
/// for either half of a neighbourhood in x, y and heading.
constexpr std::size_t least_matches = 8;

PosePrior prior_of(const Pose2& motion, const MotionNoise& noise) {
    // Added to the deviations, so that even after a very short step the prior leaves the match some freedom.
    constexpr double least_m = 0.005;
    constexpr double least_rad = 0.002;
    const MotionSigmas sigmas = motion_sigmas(motion, noise);
    return {sigmas.x_m + least_m, sigmas.y_m + least_m, sigmas.theta_rad + least_rad};
}

/// The normalised weights of the particles, which are proportional to exp(exponent * log_likelihood).
std::vector<double> weights_by_likelihood(const std::vector<Particle>& particles, double exponent) {
    std::vector<double> log_weights;
    for (const Particle& particle : particles) {
        log_weights.push_back(exponent * particle.log_likelihood);
    }
    return normalised_weights(log_weights);
}

}  // namespace

Rbpf::Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies)
    : Rbpf(settings, threads, std::move(strategies), nullptr) {}

Rbpf::Rbpf(const RbpfSettings& settings, ThreadPool& threads, FilterStrategies strategies,
           std::shared_ptr<const OccupancyGrid> known_map)
    : settings_(settings), threads_(threads), strategies_(std::move(strategies)), known_map_(std::move(known_map)) {
    if (!strategies_.resampling) {
        strategies_.resampling = std::make_shared<SystematicResampling>();
    }
    odometry_ = strategies_.odometry ? strategies_.odometry() : std::make_unique<FixedOdometry>(settings_.motion);
    for (std::size_t worker = 0; worker < threads_.size(); ++worker) {
        workers_.push_back({ScanMatcher(settings_.matcher, settings_.grid.cell_size_m), ScanInserter()});
    }
}

void Rbpf::place(std::span<const Hypothesis> hypotheses, double kept_share) {
    const PathRecord::Node past = particles_.empty() ? PoseHistory::none : best().past;
    const double exponent = gain();
    std::vector<Particle> next;
    placed_anew_ = kept_share == 0.0;
    if (kept_share > 0.0) {
        const std::vector<double> weights = weights_by_likelihood(particles_, exponent);
        for (std::size_t index = 0; index < particles_.size(); ++index) {
            particles_[index].log_likelihood = std::log(kept_share * weights[index]) / exponent;
        }
        next = std::move(particles_);
        particles_.clear();
    }
    for (const Hypothesis& hypothesis : hypotheses) {
        next.push_back({.pose = hypothesis.pose,
                        .pose_before = hypothesis.pose,
                        .predicted_motion = {},
                        .matched_motion = {},
                        .match_start = hypothesis.pose,
                        .match_prior = {},
                        .match = {},
                        .log_likelihood = hypothesis.log_weight / exponent,
                        .past = past,
                        .grid = OccupancyGrid(settings_.grid),
                        .covariance = hypothesis.covariance});
        if (past != PoseHistory::none) {
            path_.acquire(past);
        }
    }
    // The particles that are dropped. A path ends only when the new ones have it.
    if (past != PoseHistory::none) {
        for (const Particle& particle : particles_) {
            path_.release(particle.past);
        }
    }
    particles_ = std::move(next);
    choose_best();
}

void Rbpf::map_on() {
    for (Particle& particle : particles_) {
        particle.grid = *known_map_;
    }
    known_map_.reset();
}

std::optional<Update> Rbpf::update(const SensorFrame& frame) {
    const bool first = updates_ == 0 || placed_anew_;
    placed_anew_ = false;
    const Pose2 odometry_motion = first ? Pose2{} : between(odom_at_update_, frame.odom_from_robot);
    const double share = motion_share(odometry_motion, settings_);
    if (!first && share < 1.0) {
        path_.add_scan(frame.scan.stamp_ns, odometry_motion, share);
        return std::nullopt;
    }

    Update update;
    StageTimes& times = update.times;
    PreparedScan scan = timed(times.prepare_s, [&] { return prepare(frame); });
    if (first && !known_map_) {
        start(frame.odom_from_robot);
        choose_best();
        update.matched = update.corrected = snapshot(frame, odometry_motion);
    } else {
        const Step step = step_to(frame, odometry_motion, first);
        timed(times.match_s, [&] { propagate(step); });
        timed(times.match_s, [&] { match(scan, step); });
        reweight();
        update.matched = snapshot(frame, odometry_motion);
        update.degeneracy = timed(times.detect_s, [&] { return detect(update.matched); });
        timed(times.correct_s, [&] { correct(scan, step, update.degeneracy); });
        update.corrected = strategies_.corrections.empty() ? update.matched : snapshot(frame, odometry_motion);
        choose_best();
        if (!first) {
            learn(scan, step);
        }
    }
    update.pose = best().pose;
    update.covariance = covariance_ = best().covariance + pose_scatter(update.corrected.particles, best().pose);
    update.resampled = !first && timed(times.resample_s, [&] { return resample_if_poor(update.corrected); });
    timed(times.map_s, [&] { map(scan, frame.odom_from_robot); });
    remember(frame, odometry_motion);
    points_ = std::move(scan.points);
    return update;
}

Rbpf::Step Rbpf::step_to(const SensorFrame& frame, const Pose2& odometry_motion, bool first) const {
    const double duration_s = first ? 0.0 : step_duration_s(stamp_at_update_ns_, frame.scan.stamp_ns);
    const Pose2 expected_motion = odometry_->expected(odometry_motion, duration_s);
    return {.odometry_motion = odometry_motion,
            .duration_s = duration_s,
            .expected_motion = expected_motion,
            .sigmas = odometry_->sigmas(odometry_motion, duration_s),
            .prior = prior_of(expected_motion, settings_.motion),
            .independent_share =
                known_map_ && !first ? std::min(1.0, way_for_scans_m(expected_motion) / independent_scan_m) : 1.0};
}

Rbpf::PreparedScan Rbpf::prepare(const SensorFrame& frame) const {
    ScanPoints points = scan_points(frame, settings_.points);
    MatchPoints match_points(points, settings_.grid.cell_size_m);
    return {std::move(points), std::move(match_points)};
}

/// The first scan is not matched, because there is no map yet.
void Rbpf::start(const Pose2& world_from_robot) {
    particles_.assign(settings_.particles, Particle{.pose = world_from_robot,
                                                    .pose_before = world_from_robot,
                                                    .predicted_motion = {},
                                                    .matched_motion = {},
                                                    .match_start = {},
                                                    .match_prior = {},
                                                    .match = {},
                                                    .past = PoseHistory::none,
                                                    .grid = OccupancyGrid(settings_.grid)});
}

void Rbpf::propagate(const Step& step) {
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t /*worker*/) {
        Particle& particle = particles_[index];
        RandomStream random({settings_.seed, motion_draw, updates_, index});
        particle.pose_before = particle.pose;
        particle.predicted_motion =
            sample_motion(step.expected_motion, motion_sigmas(step.expected_motion, settings_.motion), random);
        particle.covariance =
            predicted_covariance(particle.covariance, particle.pose, step.expected_motion, step.sigmas);
    });
}

/// In a known map a match starts anywhere where the particle may be, so that the particles of one place search it all.
Pose2 Rbpf::match_start(const Particle& particle, std::size_t index) const {
    const Pose2 predicted = particle.pose_before * particle.predicted_motion;
    if (!known_map_) {
        return predicted;
    }
    RandomStream random({settings_.seed, place_draw, updates_, index});
    const Eigen::Vector3d draw(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d root = particle.covariance.llt().matrixL();
    return moved_by(predicted, root * draw);
}

PosePrior Rbpf::prior_of_match(const Particle& particle, const Step& step) const {
    if (!known_map_) {
        return step.prior;
    }
    const Eigen::Matrix3d to_world = turned_about_z(particle.pose_before.theta_rad);
    const Eigen::Vector3d variances = (to_world.transpose() * particle.covariance * to_world).diagonal();
    const auto widened = [](double sigma, double variance) { return std::sqrt(squared(sigma) + variance); };
    return {widened(step.prior.sigma_along_m, variances.x()), widened(step.prior.sigma_across_m, variances.y()),
            widened(step.prior.sigma_turn_rad, variances.z())};
}

/// In a known map a swarm may be large, and all particles of a neighbourhood find the same places there. So only some
/// of each neighbourhood are matched, and the others take over their matches in turn: where they began, with which
/// prior, and what came of it. Each fuses it with its own odometry and covariance. Returns those that are matched.
std::vector<std::size_t> Rbpf::share_matches() {
    matched_by_.resize(particles_.size());
    std::iota(matched_by_.begin(), matched_by_.end(), std::size_t{0});
    if (!known_map_ || particles_.size() <= whole_swarm) {
        return matched_by_;
    }
    std::map<std::array<long, 3>, std::vector<std::size_t>> neighbourhoods;
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        const Pose2& start = particles_[index].match_start;
        neighbourhoods[{std::lround(start.x_m / mode_m), std::lround(start.y_m / mode_m),
                        std::lround(wrap_angle(start.theta_rad) / mode_rad)}]
            .push_back(index);
    }
    const std::size_t each = (least_matches + neighbourhoods.size() - 1) / neighbourhoods.size();
    std::vector<std::size_t> matched;
    for (const auto& [cell, members] : neighbourhoods) {
        for (std::size_t number = 0; number < members.size(); ++number) {
            if (number < each) {
                matched.push_back(members[number]);
            } else {
                matched_by_[members[number]] = members[number % each];
            }
        }
    }
    return matched;
}

/// If no match is accepted, the particle keeps its predicted pose.
void Rbpf::match(const PreparedScan& scan, const Step& step) {
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t /*worker*/) {
        Particle& particle = particles_[index];
        particle.match_start = match_start(particle, index);
        particle.match_prior = prior_of_match(particle, step);
    });
    const std::vector<std::size_t> matched = share_matches();
    threads_.for_each(matched.size(), [&](std::size_t number, std::size_t worker) {
        Particle& particle = particles_[matched[number]];
        particle.match = workers_[worker].matcher.match_directly(grid_of(particle), scan.match_points,
                                                                 particle.match_start, particle.match_prior);
    });
    search_widely(scan, matched);
    threads_.for_each(matched.size(), [&](std::size_t number, std::size_t worker) {
        Particle& particle = particles_[matched[number]];
        if (!particle.match.accepted()) {
            particle.match =
                workers_[worker].matcher.evaluate(grid_of(particle), scan.match_points, particle.match_start);
        }
    });
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        Particle& particle = particles_[index];
        const Particle& other = particles_[matched_by_[index]];
        particle.match_start = other.match_start;
        particle.match_prior = other.match_prior;
        particle.match = other.match;
        particle.pose = particle.match.pose;
        particle.matched_motion = between(particle.pose_before, particle.pose);
    }
}

/// What the wide search of one particle finds is a motion from the pose before, which the maps of all particles have in
/// common up to what they disagree about. So only every fourth of those with a doubtful match searches, and the others
/// start from the best of the motions found. Particles lie in the order of their ancestors, so that no family is left
/// out. In a known map, which is one for all, each particle has a way of its own to the right pose.
void Rbpf::search_widely(const PreparedScan& scan, std::span<const std::size_t> matched, SearchOrder order) {
    const std::size_t every = known_map_ ? 1 : 4;
    std::vector<std::size_t> doubtful;
    for (const std::size_t index : matched) {
        if (workers_.front().matcher.is_doubtful(particles_[index].match)) {
            doubtful.push_back(index);
        }
    }
    std::vector<Pose2> motions((doubtful.size() + every - 1) / every);
    threads_.for_each(motions.size(), [&](std::size_t number, std::size_t worker) {
        const Particle& particle = particles_[doubtful[every * number]];
        motions[number] =
            between(particle.pose_before,
                    workers_[worker].matcher.search(grid_of(particle), scan.match_points, particle.match_start, order));
    });
    threads_.for_each(doubtful.size(), [&](std::size_t number, std::size_t worker) {
        Particle& particle = particles_[doubtful[number]];
        const bool has_searched = number % every == 0;
        const std::size_t first = has_searched ? number / every : 0;
        std::vector<Pose2> starts;
        for (std::size_t at = first; at < (has_searched ? first + 1 : motions.size()); ++at) {
            starts.push_back(particle.pose_before * motions[at]);
        }
        particle.match = workers_[worker].matcher.match_from(
            starts, particle.match, grid_of(particle), scan.match_points, particle.match_start, particle.match_prior);
    });
}

/// After a scan that fits nowhere, as where the scans pause while the robot turns, the pose may be off in place and
/// heading at once. If the next scan then fits nowhere well, either, all pairs of both are tried.
void Rbpf::search_widely(const PreparedScan& scan, std::span<const std::size_t> matched) {
    constexpr double well = 2.0 / 3.0;  // of the usual score
    constexpr double nowhere = 0.5;
    search_widely(scan, matched, SearchOrder::headings_first);
    const auto lower_score = [](const Particle& a, const Particle& b) { return a.match.score < b.match.score; };
    const double found = std::max_element(particles_.begin(), particles_.end(), lower_score)->match.score;
    if (!known_map_ && last_fitted_nowhere_ && found < well * usual_score_) {
        search_widely(scan, matched, SearchOrder::all_pairs);
    }
    last_fitted_nowhere_ = found < nowhere * usual_score_;
}

void Rbpf::reweight() {
    for (Particle& particle : particles_) {
        particle.log_likelihood += particle.match.log_likelihood;
    }
}

double Rbpf::gain() const { return settings_.likelihood_gain * noise_.weight(settings_.full_weight_sd_m); }

Degeneracy Rbpf::detect(const ParticleSnapshot& swarm) const {
    return strategies_.detector ? strategies_.detector(swarm) : Degeneracy{};
}

void Rbpf::correct(const PreparedScan& scan, const Step& step, const Degeneracy& degeneracy) {
    const auto correct_each = [&](const std::vector<std::size_t>& indices) {
        threads_.for_each(indices.size(), [&](std::size_t number, std::size_t worker) {
            const std::size_t index = indices[number];
            const ScanMatch* alike = matched_by_[index] == index ? nullptr : &particles_[matched_by_[index]].match;
            correct(particles_[index], alike, scan, step, degeneracy, workers_[worker].matcher);
        });
    };
    std::vector<std::size_t> matched, others;
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        (matched_by_[index] == index ? matched : others).push_back(index);
    }
    correct_each(matched);
    correct_each(others);
}

void Rbpf::correct(Particle& particle, const ScanMatch* alike, const PreparedScan& scan, const Step& step,
                   const Degeneracy& degeneracy, ScanMatcher& matcher) const {
    if (!strategies_.corrections.empty()) {
        const Pose2& before = particle.pose_before;
        const MatchContext context{
            .matcher = matcher,
            .grid = grid_of(particle),
            .points = scan.match_points,
            .predicted = particle.match_start,
            .prior = particle.match_prior,
            .odometry = before * step.expected_motion,
            .odometry_information =
                predicted_covariance(Eigen::Matrix3d::Zero(), before, step.expected_motion, step.sigmas).inverse(),
            .degeneracy = degeneracy,
            .information_factor =
                step.independent_share * beam_noise_.information_factor(settings_.matcher.beam_sigma_m),
            .pose_information =
                known_map_ ? std::optional<Eigen::Matrix3d>(particle.covariance.inverse()) : std::nullopt,
            .alike = alike};
        const double matched = particle.match.log_likelihood;
        for (const auto& correction : strategies_.corrections) {
            particle.match = correction->correct(context, particle.match);
        }
        particle.pose = particle.match.pose;
        particle.matched_motion = between(before, particle.pose);
        particle.log_likelihood += particle.match.log_likelihood - matched;
    }
    particle.covariance = corrected_covariance(particle.covariance, particle.match.information);
}

void Rbpf::learn(const PreparedScan& scan, const Step& step) {
    constexpr double remembered_updates = 300.0;
    const Particle& particle = best();
    usual_score_ += (particle.match.score - usual_score_) / std::min(static_cast<double>(updates_), remembered_updates);
    const auto pose_before = [&](std::size_t updates) {
        return updates == 0 ? particle.pose : path_.pose_before(particle.past, updates - 1);
    };
    const Eigen::Matrix3d world_from_robot = turned_about_z(particle.pose.theta_rad);
    if (particle.match.accepted() && scan.match_points.beams > 0) {
        noise_.learn(-2.0 * squared(settings_.matcher.beam_sigma_m) * particle.match.log_likelihood /
                     static_cast<double>(scan.match_points.beams));
        beam_noise_.learn(particle.match.misfit_m2);
    }
    odometry_->learn({.odometry = step.odometry_motion,
                      .duration_s = step.duration_s,
                      .information = world_from_robot.transpose() * particle.match.information * world_from_robot,
                      .pose_before = pose_before});
}

bool Rbpf::resample_if_poor(const ParticleSnapshot& swarm) {
    if (effective_sample_size(weights_of(swarm.particles)) >=
            settings_.resample_share * static_cast<double>(particles_.size()) &&
        !strategies_.resampling->is_due(swarm.particles)) {
        return false;
    }
    RandomStream random({settings_.seed, resampling_draw, updates_});
    std::vector<Particle> next;
    next.reserve(particles_.size());
    for (const Descendant& descendant : strategies_.resampling->resample(swarm.particles, random)) {
        next.push_back(particles_[descendant.parent]);
        next.back().pose = descendant.pose;
        next.back().log_likelihood = descendant.weight == 1.0 ? 0.0 : std::log(descendant.weight) / gain();
        path_.acquire(next.back().past);
    }
    for (const Particle& particle : particles_) {
        path_.release(particle.past);
    }
    particles_ = std::move(next);
    choose_best();
    return true;
}

/// A scan enters the maps only if the robot has moved enough since the last one that did. Otherwise the evidence for a
/// place would grow with the time that the robot stands there.
void Rbpf::map(const PreparedScan& scan, const Pose2& odom_from_robot) {
    if (known_map_) {
        return;
    }
    if (odom_at_mapping_) {
        const Pose2 since = between(*odom_at_mapping_, odom_from_robot);
        if (std::hypot(since.x_m, since.y_m) < settings_.insert_distance_m &&
            std::abs(since.theta_rad) < settings_.insert_turn_rad) {
            return;
        }
    }
    odom_at_mapping_ = odom_from_robot;
    threads_.for_each(particles_.size(), [&](std::size_t index, std::size_t worker) {
        workers_[worker].inserter.insert(particles_[index].grid, scan.points, particles_[index].pose);
    });
}

void Rbpf::remember(const SensorFrame& frame, const Pose2& odometry_motion) {
    path_.add_update(frame.scan.stamp_ns, odometry_motion);
    std::vector<PathRecord::Node> pasts;
    for (Particle& particle : particles_) {
        particle.past = path_.extend(particle.past, particle.pose);
        pasts.push_back(particle.past);
    }
    path_.settle(pasts);
    odom_at_update_ = frame.odom_from_robot;
    stamp_at_update_ns_ = frame.scan.stamp_ns;
    ++updates_;
}

ParticleSnapshot Rbpf::snapshot(const SensorFrame& frame, const Pose2& odometry_motion) const {
    const std::vector<double> weights = weights_by_likelihood(particles_, gain());
    ParticleSnapshot swarm{
        .stamp_ns = frame.scan.stamp_ns, .update = updates_, .odometry_motion = odometry_motion, .particles = {}};
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        const Particle& particle = particles_[index];
        swarm.particles.push_back({.pose = particle.pose,
                                   .matched_motion = particle.matched_motion,
                                   .predicted_motion = particle.predicted_motion,
                                   .log_likelihood = particle.log_likelihood,
                                   .log_likelihood_increment = particle.match.log_likelihood,
                                   .match_score = particle.match.score,
                                   .weight = weights[index]});
    }
    return swarm;
}

/// In a known map the particles of one place may outweigh the heaviest one, which stands at another.
void Rbpf::choose_best() {
    if (!known_map_) {
        best_ = static_cast<std::size_t>(std::ranges::max_element(particles_, {}, &Particle::log_likelihood) -
                                         particles_.begin());
        return;
    }
    const std::vector<double> weights = weights_by_likelihood(particles_, gain());
    std::vector<SnapshotParticle> swarm(particles_.size());
    for (std::size_t index = 0; index < particles_.size(); ++index) {
        swarm[index].pose = particles_[index].pose;
        swarm[index].weight = weights[index];
    }
    best_ = modes_of(swarm).front().particles.front();
}

Pose2 Rbpf::pose() const { return best().pose * path_.motion_since_update(); }

Eigen::Matrix3d Rbpf::pose_covariance() const {
    const Pose2& motion = path_.motion_since_update();
    if (motion == Pose2{}) {
        return covariance_;
    }
    const double since_s = step_duration_s(stamp_at_update_ns_, path_.last_stamp_ns());
    return predicted_covariance(covariance_, best().pose, motion, odometry_->sigmas(motion, since_s));
}

void Rbpf::visit_trajectory(const PoseVisitor& visit) const {
    if (!particles_.empty()) {
        path_.visit_trajectory(best().past, visit);
    }
}

}  // namespace ddtool
