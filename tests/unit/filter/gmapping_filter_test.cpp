#include "ddtool/filter/gmapping_filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "room_run.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

GmappingSettings few_hypotheses(std::size_t particles = 5) {
    GmappingSettings settings;
    settings.particles = particles;
    return settings;
}

/// The updates of a filter that has processed all frames, and what it says at the end.
struct Outcome {
    std::vector<Update> updates;
    Trajectory trajectory;
};

Outcome outcome_of(const std::vector<SensorFrame>& frames, const GmappingSettings& settings, std::size_t threads = 1) {
    ThreadPool pool(threads);
    GmappingFilter filter(settings, pool);
    Outcome outcome;
    for (const SensorFrame& frame : frames) {
        if (std::optional<Update> update = filter.update(frame)) {
            outcome.updates.push_back(std::move(*update));
        }
    }
    outcome.trajectory = filter.trajectory();
    return outcome;
}

double largest_gap_m(const Trajectory& trajectory, const std::vector<SensorFrame>& frames) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        largest = std::max(largest, distance_m(trajectory[i].pose, *frames[i].world_from_robot));
    }
    return largest;
}

/// Frames of a lidar that sees nothing, mounted askew on a robot that drives straight on.
std::vector<SensorFrame> blind_drive(std::size_t scans, double step_m) {
    std::vector<SensorFrame> frames(scans, room_drive().front());
    for (std::size_t i = 0; i < scans; ++i) {
        std::fill(frames[i].scan.ranges_m.begin(), frames[i].scan.ranges_m.end(), LaserScan::no_return);
        frames[i].scan.stamp_ns = static_cast<std::int64_t>(i);
        frames[i].robot_from_laser = {0.4, -0.2, 0.7};
        frames[i].odom_from_robot = {1.0 + step_m * static_cast<double>(i), 2.0, 0.0};
    }
    return frames;
}

constexpr LinearMotionNoise no_motion_noise{0.0, 0.0, 0.0, 0.0};

TEST(GmappingFilter, KnowsWhereItIsInARoom) {
    const Outcome outcome = outcome_of(room_drive(), few_hypotheses());
    expect_finite_pose_for_every_scan(outcome.trajectory, room_drive());
    EXPECT_LT(largest_gap_m(outcome.trajectory, room_drive()), 0.12);
}

TEST(GmappingFilter, IsTheSameBytesOnAnyNumberOfThreads) {
    GmappingSettings settings = few_hypotheses();
    settings.update_distance_m = 0.3;
    settings.resample_share = 1.0;
    const std::vector<Pose2> one = poses_of(outcome_of(room_drive(), settings).trajectory);
    EXPECT_EQ(poses_of(outcome_of(room_drive(), settings, 3).trajectory), one);
    settings.seed = 2;
    EXPECT_NE(poses_of(outcome_of(room_drive(), settings).trajectory), one);
}

TEST(GmappingFilter, WithoutReturnsAndNoiseIsTheOdometryWhereverTheLaserIs) {
    GmappingSettings settings = few_hypotheses(2);
    settings.motion = no_motion_noise;
    const std::vector<SensorFrame> frames = blind_drive(40, 0.1);
    const Outcome outcome = outcome_of(frames, settings);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_LT(distance_m(outcome.trajectory[i].pose, frames[i].odom_from_robot), 1e-9) << i;
    }
    ASSERT_EQ(outcome.updates.size(), 4U);
    for (const SnapshotParticle& particle : outcome.updates.back().matched.particles) {
        EXPECT_NEAR(particle.matched_motion.x_m, 1.0, 1e-9);
        EXPECT_NEAR(particle.predicted_motion.x_m, 1.0, 1e-9);
        EXPECT_NEAR(particle.matched_motion.y_m, 0.0, 1e-9);
        EXPECT_EQ(particle.match_score, 0.0);
    }
}

/// The noise of each scan is drawn for that scan. Its deviation grows in proportion to the scan's motion, so a metre in
/// ten steps spreads the swarm less than a metre in one, by the root of ten.
TEST(GmappingFilter, DrawsNoiseAtEveryScan) {
    const auto spread_m = [](std::size_t scans) {
        GmappingSettings settings = few_hypotheses(2'000);
        settings.motion = {0.1, 0.0, 0.0, 0.0};
        std::vector<SensorFrame> frames = blind_drive(scans + 1, 1.0 / static_cast<double>(scans));
        for (SensorFrame& frame : frames) {
            frame.robot_from_laser = {};
        }
        frames.back().odom_from_robot.x_m += 1e-9;  // a metre by rounding, too
        double squares = 0.0;
        const Outcome outcome = outcome_of(frames, settings);
        for (const SnapshotParticle& particle : outcome.updates.back().matched.particles) {
            squares += std::pow(particle.predicted_motion.x_m - 1.0, 2);
        }
        EXPECT_EQ(outcome.updates.size(), 2U);
        return std::sqrt(squares / 2'000.0);
    };
    constexpr double five_standard_errors = 5.0 / 63.0;
    EXPECT_NEAR(spread_m(1), 0.1, 0.1 * five_standard_errors);
    EXPECT_NEAR(spread_m(10), 0.1 / std::sqrt(10.0), 0.1 / std::sqrt(10.0) * five_standard_errors);
}

/// The ways of all scans add up, so that a robot that drives to and fro on the spot gets updates, too.
TEST(GmappingFilter, UpdatesByTheWayDrivenAndNotByTheDistance) {
    std::vector<SensorFrame> frames = blind_drive(22, 0.0);
    for (std::size_t i = 1; i < frames.size(); i += 2) {
        frames[i].odom_from_robot.x_m += 0.101;
    }
    EXPECT_EQ(outcome_of(frames, few_hypotheses(1)).updates.size(), 3U);
    EXPECT_EQ(outcome_of(blind_drive(30, 0.0), few_hypotheses(1)).updates.size(), 1U);
}

TEST(GmappingFilter, CountsGroundNeverSeenAsMisses) {
    std::vector<SensorFrame> frames = blind_drive(3, 1.1);
    frames[1].scan.ranges_m.assign(frames[1].scan.ranges_m.size(), 3.0F);
    frames[1].scan.ranges_m[3] = LaserScan::invalid;
    frames[1].scan.ranges_m[4] = LaserScan::no_return;
    frames[1].scan.ranges_m[5] = static_cast<float>(frames[1].scan.range_max_m);  // beyond the margin
    const auto beams = static_cast<double>(frames[1].scan.ranges_m.size() - 3);
    const Outcome outcome = outcome_of(frames, few_hypotheses(2));
    ASSERT_EQ(outcome.updates.size(), 3U);
    const auto increment = [&](std::size_t update) {
        return outcome.updates[update].matched.particles.front().log_likelihood_increment;
    };
    EXPECT_NEAR(increment(1), -beams * 0.5 / 0.075, 1e-9);
    EXPECT_EQ(increment(2), 0.0);
    EXPECT_NEAR(outcome.updates[2].matched.particles.front().log_likelihood, increment(1), 1e-12);
}

TEST(GmappingFilter, WeighsByTheLikelihoodToASmallPower) {
    GmappingSettings settings = few_hypotheses(4);
    settings.resample_share = 0.0;
    const Outcome outcome = outcome_of(room_drive(), settings);
    const std::vector<SnapshotParticle>& swarm = outcome.updates.back().matched.particles;
    const double gain = 1.0 / (settings.likelihood_smoothing * 4.0);
    for (const SnapshotParticle& particle : swarm) {
        const double expected = std::exp(gain * (particle.log_likelihood - swarm.front().log_likelihood));
        EXPECT_NEAR(particle.weight / swarm.front().weight, expected, 1e-9);
    }
}

TEST(GmappingFilter, KeepsThePredictedPoseOfAMatchThatScoresTooLittle) {
    GmappingSettings settings = few_hypotheses(3);
    settings.least_score = 1e6;
    const Outcome outcome = outcome_of(room_drive(), settings);
    ASSERT_GT(outcome.updates.size(), 2U);
    for (const SnapshotParticle& particle : outcome.updates.back().matched.particles) {
        EXPECT_EQ(particle.matched_motion, particle.predicted_motion);
        EXPECT_GT(particle.match_score, 0.0);
    }
}

/// After resampling the likelihood since then is 0 for all, and the best particle is still told by its whole life.
TEST(GmappingFilter, TakesTheParticleOfTheLikeliestLifeForTheBest) {
    GmappingSettings settings = few_hypotheses(6);
    settings.resample_share = 1.0;
    settings.update_distance_m = 0.3;
    ThreadPool threads(1);
    GmappingFilter filter(settings, threads);
    std::size_t resamplings = 0;
    for (const SensorFrame& frame : room_drive()) {
        const std::optional<Update> update = filter.update(frame);
        resamplings += update && update->resampled ? 1U : 0U;
        for (const GmappingParticle& particle : filter.particles()) {
            ASSERT_LE(particle.life_log_likelihood, filter.best().life_log_likelihood);
            ASSERT_LE(particle.life_log_likelihood, particle.log_likelihood);
        }
    }
    EXPECT_GT(resamplings, 2U);
    EXPECT_LT(filter.best().life_log_likelihood, filter.best().log_likelihood);
}

TEST(GmappingFilter, AsksItsDetectorAndChangesNothingForWhatItSays) {
    ThreadPool threads(1);
    const GmappingSettings settings = few_hypotheses();
    std::size_t asked = 0;
    GmappingStrategies strategies;
    strategies.detector = [&](const ParticleSnapshot& swarm) {
        ++asked;
        EXPECT_EQ(swarm.particles.size(), settings.particles);
        return Degeneracy{1.0};
    };
    GmappingFilter filter(settings, threads, strategies);
    std::size_t updates = 0;
    for (const SensorFrame& frame : room_drive()) {
        if (const std::optional<Update> update = filter.update(frame)) {
            EXPECT_EQ(update->degeneracy.degree, updates++ == 0 ? 0.0 : 1.0);
        }
    }
    EXPECT_EQ(asked, updates - 1);
    EXPECT_EQ(poses_of(filter.trajectory()), poses_of(outcome_of(room_drive(), settings).trajectory));
}

TEST(GmappingFilter, TakesUpWhereItsStrategiesLeaveTheParticles) {
    ThreadPool threads(1);
    GmappingSettings settings = few_hypotheses();
    settings.update_distance_m = 0.3;
    GmappingStrategies strategies;
    strategies.detector = [](const ParticleSnapshot&) { return Degeneracy{1.0}; };
    strategies.failed_match = FailedMatchSettings{.least_score = 10.0, .search = std::nullopt, .weighs_odometry = true};
    GmappingFilter filter(settings, threads, strategies);
    std::size_t moved = 0;
    for (const SensorFrame& frame : room_drive()) {
        const std::vector<GmappingParticle> before(filter.particles().begin(), filter.particles().end());
        const std::optional<Update> update = filter.update(frame);
        for (std::size_t i = 0; update && !before.empty() && i < before.size(); ++i) {
            const SnapshotParticle& matched = update->matched.particles[i];
            const SnapshotParticle& corrected = update->corrected.particles[i];
            const double since = corrected.log_likelihood - before[i].log_likelihood;
            EXPECT_NEAR(since, corrected.log_likelihood_increment, 1e-9);
            EXPECT_TRUE(corrected.matched_motion == matched.matched_motion ||
                        corrected.matched_motion == matched.predicted_motion);
            moved += corrected.pose == matched.pose ? 0 : 1;
        }
    }
    EXPECT_GT(moved, 0U);
}

TEST(GmappingFilter, SaysHowSureItIsBetweenUpdates) {
    ThreadPool threads(1);
    GmappingFilter filter(few_hypotheses(), threads);
    double at_update = 0.0;
    double grown = 0.0;
    for (const SensorFrame& frame : blind_drive(15, 0.1)) {
        const bool updated = filter.update(frame).has_value();
        const double now = filter.pose_covariance().trace();
        EXPECT_TRUE(filter.pose_covariance().allFinite());
        (updated ? at_update : grown) = now;
        EXPECT_TRUE(updated || now > at_update);
    }
    EXPECT_GT(grown, at_update);
}

TEST(GmappingFilter, DrawsTheMapOfTheBestParticle) {
    ThreadPool threads(1);
    GmappingFilter filter(few_hypotheses(), threads);
    for (const SensorFrame& frame : room_drive()) {
        filter.update(frame);
    }
    const Pose2 pose = filter.trajectory().front().pose;
    const double cell_m = filter.map().cell_size_m();
    EXPECT_FALSE(filter.map().observed_box().empty());
    EXPECT_FALSE(filter.map().occupied(
        {static_cast<int>(std::floor(pose.x_m / cell_m)), static_cast<int>(std::floor(pose.y_m / cell_m))}));
}

TEST(GmappingFilter, NamesPosesThatJumpToNowhere) {
    for (const double distance_m : {1e8, 1e12}) {
        std::vector<SensorFrame> frames = room_drive();
        for (std::size_t i = frames.size() / 2; i < frames.size(); ++i) {
            frames[i].odom_from_robot = Pose2{distance_m, 0.0, 0.0} * frames[i].odom_from_robot;
        }
        EXPECT_THAT(test::thrown_text<MapTooLarge>([&] { outcome_of(frames, few_hypotheses(2)); }),
                    testing::HasSubstr("the poses jump"));
    }
}

TEST(GmappingFilter, BeforeTheFirstScanHasNoTrajectory) {
    EXPECT_TRUE(outcome_of({}, few_hypotheses()).trajectory.empty());
}

}  // namespace
}  // namespace ddtool
