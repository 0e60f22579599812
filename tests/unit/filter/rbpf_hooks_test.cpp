#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "room_run.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

void expect_near(const Pose2& a, const Pose2& b) {
    EXPECT_LT(distance_m(a, b), 1e-9);
    EXPECT_NEAR(wrap_angle(a.theta_rad - b.theta_rad), 0.0, 1e-9);
}

std::vector<Update> updates_of(const RbpfSettings& settings, const FilterStrategies& strategies = {}) {
    std::vector<Update> updates;
    ThreadPool threads(2);
    Rbpf filter(settings, threads, strategies);
    for (const SensorFrame& frame : room_drive()) {
        if (auto update = filter.update(frame)) {
            updates.push_back(std::move(*update));
        }
    }
    return updates;
}

/// The snapshots of the updates at which the robot had moved.
std::vector<ParticleSnapshot> snapshots_of(const RbpfSettings& settings) {
    std::vector<ParticleSnapshot> snapshots;
    for (Update& update : updates_of(settings)) {
        snapshots.push_back(std::move(update.matched));
    }
    snapshots.erase(snapshots.begin());
    return snapshots;
}

RbpfSettings resampling_below(double share) {
    RbpfSettings settings = few_particles();
    settings.resample_share = share;
    return settings;
}

constexpr double never = 0.0;
constexpr double always = 1.1;

TEST(Snapshot, WeightsAreThoseOfTheAccumulatedLikelihood) {
    RbpfSettings settings = resampling_below(never);
    settings.full_weight_sd_m = 0.0;
    for (const ParticleSnapshot& swarm : snapshots_of(settings)) {
        std::vector<double> log_weights;
        double sum = 0.0;
        for (const SnapshotParticle& particle : swarm.particles) {
            log_weights.push_back(settings.likelihood_gain * particle.log_likelihood);
            sum += particle.weight;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
        const std::vector<double> weights = normalised_weights(log_weights);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            EXPECT_NEAR(swarm.particles[i].weight, weights[i], 1e-12);
        }
    }
}

TEST(Snapshot, WeightsAreFlatterWhereScansLieFarFromTheMap) {
    RbpfSettings settings = resampling_below(never);
    const auto sharpest = [](const std::vector<ParticleSnapshot>& snapshots) {
        double most = 0.0;
        for (const SnapshotParticle& particle : snapshots.back().particles) {
            most = std::max(most, particle.weight);
        }
        return most;
    };
    settings.full_weight_sd_m = 0.0;
    const double alike = sharpest(snapshots_of(settings));
    settings.full_weight_sd_m = 1e-4;  // every scan is noisier
    EXPECT_LT(sharpest(snapshots_of(settings)), alike);
}

TEST(Snapshot, LikelihoodAccumulatesWithoutResampling) {
    const std::vector<ParticleSnapshot> snapshots = snapshots_of(resampling_below(never));
    ASSERT_GT(snapshots.size(), 10U);
    for (std::size_t i = 1; i < snapshots.size(); ++i) {
        EXPECT_EQ(snapshots[i].update, snapshots[i - 1].update + 1);
        for (std::size_t p = 0; p < snapshots[i].particles.size(); ++p) {
            const SnapshotParticle& now = snapshots[i].particles[p];
            const SnapshotParticle& before = snapshots[i - 1].particles[p];
            EXPECT_NEAR(now.log_likelihood, before.log_likelihood + now.log_likelihood_increment, 1e-9);
            expect_near(now.pose, before.pose * now.matched_motion);
            EXPECT_GE(now.match_score, 0.0);
            EXPECT_LE(now.match_score, 1.0);
        }
    }
}

TEST(Snapshot, LikelihoodStartsAgainAfterResampling) {
    for (const ParticleSnapshot& swarm : snapshots_of(resampling_below(always))) {
        for (const SnapshotParticle& particle : swarm.particles) {
            EXPECT_EQ(particle.log_likelihood, particle.log_likelihood_increment);
        }
    }
}

TEST(Snapshot, PredictionsScatterAroundOdometry) {
    RbpfSettings settings = few_particles();
    settings.motion = {0.0, 0.0, 0.0, 0.0};
    for (const ParticleSnapshot& swarm : snapshots_of(settings)) {
        for (const SnapshotParticle& particle : swarm.particles) {
            EXPECT_EQ(particle.predicted_motion, swarm.odometry_motion);
        }
    }
    for (const ParticleSnapshot& swarm : snapshots_of(few_particles())) {
        EXPECT_NE(swarm.particles[0].predicted_motion, swarm.particles[1].predicted_motion);
    }
}

TEST(Detector, AloneChangesNothing) {
    std::atomic<int> calls = 0;
    FilterStrategies strategies;
    strategies.detector = [&](const ParticleSnapshot&) {
        ++calls;
        return Degeneracy{1.0};
    };
    EXPECT_EQ(poses_of(filtered(room_drive(), few_particles(), strategies)),
              poses_of(filtered(room_drive(), few_particles())));
    EXPECT_GT(calls, 10);
}

class KeepMatch : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& /*context*/, const ScanMatch& found) const override { return found; }
};

TEST(Correction, ThatKeepsTheMatchChangesNothing) {
    FilterStrategies strategies;
    strategies.corrections = {std::make_shared<KeepMatch>()};
    const Trajectory plain = filtered(room_drive(), few_particles());
    const Trajectory kept = filtered(room_drive(), few_particles(), strategies);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        expect_near(kept[i].pose, plain[i].pose);
    }
}

/// Always returns the odometry's pose, whatever the match is.
class TrustOdometry : public PoseCorrection {
public:
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override {
        EXPECT_EQ(context.degeneracy.degree, 0.25);
        EXPECT_GT(context.points.beams, 0U);
        ScanMatch match = found;
        match.pose = context.odometry;
        return match;
    }
};

FilterStrategies trusting_odometry() {
    FilterStrategies strategies;
    strategies.detector = [](const ParticleSnapshot&) { return Degeneracy{0.25}; };
    strategies.corrections = {std::make_shared<KeepMatch>(), std::make_shared<TrustOdometry>()};
    return strategies;
}

TEST(Update, OfTheFirstScanIsOneLikeAnyOther) {
    const Update first = updates_of(few_particles()).front();
    const Pose2 start = room_drive().front().odom_from_robot;
    EXPECT_EQ(first.matched.update, 0U);
    EXPECT_EQ(first.matched.stamp_ns, room_drive().front().scan.stamp_ns);
    EXPECT_EQ(first.degeneracy.degree, 0.0);
    EXPECT_EQ(first.pose, start);
    EXPECT_FALSE(first.resampled);
    ASSERT_EQ(first.matched.particles.size(), few_particles().particles);
    for (const SnapshotParticle& particle : first.matched.particles) {
        EXPECT_EQ(particle.pose, start);
        EXPECT_EQ(particle.matched_motion, Pose2{});
        EXPECT_DOUBLE_EQ(particle.weight, 1.0 / static_cast<double>(few_particles().particles));
    }
}

TEST(Update, IsEmptyWhereTheRobotHasHardlyMoved) {
    ThreadPool threads(1);
    Rbpf filter(few_particles(), threads);
    EXPECT_TRUE(filter.update(room_drive().front()));
    EXPECT_FALSE(filter.update(room_drive().front()));
}

TEST(Update, HasTheSwarmAsMatchedAndAsCorrected) {
    for (const Update& update : updates_of(few_particles())) {
        for (std::size_t p = 0; p < update.matched.particles.size(); ++p) {
            EXPECT_EQ(update.corrected.particles[p].pose, update.matched.particles[p].pose);
        }
    }
    double apart_m = 0.0;
    for (const Update& update : updates_of(few_particles(), trusting_odometry())) {
        EXPECT_EQ(update.degeneracy.degree, update.matched.update > 0 ? 0.25 : 0.0);
        apart_m += distance_m(update.corrected.particles[0].pose, update.matched.particles[0].pose);
    }
    EXPECT_GT(apart_m, 0.01);
}

TEST(Correction, PutsTheParticleWhereItSays) {
    const Trajectory trajectory = filtered(room_drive(), few_particles(3), trusting_odometry(), 2);
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        EXPECT_LT(distance_m(trajectory[i].pose, room_drive()[i].odom_from_robot), 1e-6) << i;
    }
}

/// Records the past poses of the best particle, as the filter passes them to learn(). The best particle may change from
/// update to update.
class WatchesThePast : public FixedOdometry {
public:
    WatchesThePast() : FixedOdometry(RbpfSettings{}.motion) {}
    void learn(const ObservedMotion& motion) override {
        ++updates;
        path.clear();
        for (std::size_t back = updates; back > 0; --back) {
            path.push_back(motion.pose_before(back));
        }
        path.push_back(motion.pose_before(0));
    }
    std::size_t updates = 0;
    std::vector<Pose2> path;
};

TEST(Odometry, LearnsFromThePastOfTheParticleBelievedNow) {
    WatchesThePast* odometry = nullptr;  // points to the object inside the filter
    FilterStrategies strategies;
    strategies.odometry = [&] {
        auto made = std::make_unique<WatchesThePast>();
        odometry = made.get();
        return made;
    };
    ThreadPool threads(1);
    Rbpf filter(resampling_below(never), threads, strategies);
    for (const SensorFrame& frame : room_drive()) {
        const std::optional<Update> update = filter.update(frame);
        if (update && update->matched.update > 0) {
            EXPECT_EQ(odometry->path.back(), update->pose);
        }
    }
    std::vector<Pose2> updates;
    const Trajectory trajectory = filter.trajectory();
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        if (trajectory[i].pose == odometry->path[updates.size()]) {
            updates.push_back(trajectory[i].pose);
        }
        if (updates.size() == odometry->path.size()) {
            break;
        }
    }
    EXPECT_EQ(updates, odometry->path);
}

/// Replaces all particles by copies of the second one, which lie beside each other.
class SecondOnly : public Resampling {
public:
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles,
                                     RandomStream& /*random*/) const override {
        double weight = 0.0;
        std::vector<Descendant> next;
        for (const SnapshotParticle& particle : particles) {
            weight += particle.weight;
            next.push_back({1, particles[1].pose * Pose2{1e-3 * static_cast<double>(next.size()), 0.0, 0.0}});
        }
        EXPECT_NEAR(weight, 1.0, 1e-12);
        return next;
    }
};

TEST(Resampling, MakesTheNextGenerationAsItSays) {
    FilterStrategies strategies;
    strategies.resampling = std::make_shared<SecondOnly>();
    ThreadPool threads(1);
    Rbpf filter(resampling_below(always), threads, strategies);
    std::size_t resampled = 0;
    for (const SensorFrame& frame : room_drive()) {
        const std::optional<Update> update = filter.update(frame);
        if (update && update->matched.update > 0) {
            EXPECT_TRUE(update->resampled);
            ++resampled;
            const Pose2 second = update->corrected.particles[1].pose;
            for (std::size_t p = 0; p < filter.particles().size(); ++p) {
                expect_near(filter.particles()[p].pose, second * Pose2{1e-3 * static_cast<double>(p), 0.0, 0.0});
                EXPECT_EQ(filter.particles()[p].log_likelihood, 0.0);
            }
        }
    }
    EXPECT_GT(resampled, 10U);
}

TEST(Resampling, IsLeftOutWhileTheSwarmIsRich) {
    for (const Update& update : updates_of(resampling_below(never))) {
        EXPECT_FALSE(update.resampled);
    }
}

TEST(PoseCovariance, GrowsWithTheOdometrySinceTheLastUpdate) {
    ThreadPool threads(1);
    RbpfSettings settings = few_particles();
    settings.update_distance_m = 0.5;
    settings.update_turn_rad = 0.5;
    Rbpf filter(settings, threads);
    int between = 0;
    double before_m2 = 0.0;
    for (const SensorFrame& frame : room_drive()) {
        const std::optional<Update> update = filter.update(frame);
        const Eigen::Matrix3d covariance = filter.pose_covariance();
        const double spread_m2 = covariance(0, 0) + covariance(1, 1);
        EXPECT_GE(covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-12);
        EXPECT_NEAR((covariance - covariance.transpose()).norm(), 0.0, 1e-12);
        if (!update) {
            EXPECT_GE(spread_m2, before_m2);
            ++between;
        } else {
            EXPECT_NEAR((covariance - update->covariance).norm(), 0.0, 1e-12);
        }
        before_m2 = spread_m2;
    }
    EXPECT_GT(between, 0);
}

}  // namespace
}  // namespace ddtool
