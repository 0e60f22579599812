#include "check/motion_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool::check {
namespace {

Update update_of(const Pose2& odometry, const Pose2& matched, std::uint64_t number = 1, double score = 0.9) {
    Update update;
    update.matched.update = update.corrected.update = number;
    update.matched.odometry_motion = update.corrected.odometry_motion = odometry;
    SnapshotParticle good;
    good.matched_motion = matched;
    good.match_score = score;
    SnapshotParticle worse;
    worse.matched_motion = {9.0, 9.0, 3.0};
    worse.log_likelihood = -1.0;
    update.matched.particles = update.corrected.particles = {worse, good};
    return update;
}

/// A drive in which every motion is matched as `matched_of` says.
template <typename Function>
MotionEvidence driven(const Function& matched_of, Openness openness = Openness::held) {
    MotionWitness witness;
    for (int step = 0; step < 100; ++step) {
        const Pose2 odometry{0.1, 0.0, 0.05 * std::sin(step)};
        witness.add(update_of(odometry, matched_of(odometry, step)), openness);
    }
    return witness.evidence();
}

TEST(MotionEvidence, EqualMotionsAgree) {
    const MotionEvidence evidence = driven([](const Pose2& odometry, int) { return odometry; });
    EXPECT_EQ(evidence.updates, 100U);
    EXPECT_NEAR(evidence.odometry_m, 10.0, 1e-9);
    EXPECT_NEAR(evidence.along, 1.0, 1e-9);
    EXPECT_NEAR(evidence.across, 0.0, 1e-9);
    EXPECT_NEAR(evidence.turn, 1.0, 1e-9);
    EXPECT_NEAR(evidence.score, 0.9, 1e-9);
    EXPECT_EQ(evidence.jumps + evidence.unmatched, 0U);
    EXPECT_LT(evidence.usual_m, 0.01);
}

TEST(MotionEvidence, TheFirstUpdateHasNoMotion) {
    MotionWitness witness;
    witness.add(update_of({}, {}, 0), Openness::walls);
    EXPECT_EQ(witness.evidence().updates, 0U);
    EXPECT_EQ(witness.evidence().along, 1.0);
}

TEST(MotionEvidence, ScalesShowInTheirRegressions) {
    const MotionEvidence evidence = driven([](const Pose2& odometry, int) {
        return Pose2{0.8 * odometry.x_m, 0.2 * odometry.x_m, -odometry.theta_rad};
    });
    EXPECT_NEAR(evidence.along, 0.8, 1e-9);
    EXPECT_NEAR(evidence.across, 0.2, 1e-9);
    EXPECT_NEAR(evidence.turn, -1.0, 1e-9);
}

TEST(MotionEvidence, ALaserThatSitsElsewhereShowsAsALever) {
    const Pose2 elsewhere{0.5, -0.2, 0.0};
    const MotionEvidence evidence =
        driven([&](const Pose2& odometry, int) { return elsewhere * odometry * inverse(elsewhere); });
    EXPECT_NEAR(evidence.lever_m.x_m, 0.5, 0.02);
    EXPECT_NEAR(evidence.lever_m.y_m, -0.2, 0.02);
}

TEST(MotionEvidence, JumpsAndMissesAreCounted) {
    const MotionEvidence evidence = driven([](const Pose2& odometry, int step) {
        return step == 50 ? Pose2{odometry.x_m + 0.7, 0.0, odometry.theta_rad} : odometry;
    });
    EXPECT_EQ(evidence.jumps, 1U);
    EXPECT_NEAR(evidence.worst_jump_m, 0.7, 1e-9);
    MotionWitness witness;
    witness.add(update_of({0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}, 1, 0.05), Openness::held);
    EXPECT_EQ(witness.evidence().unmatched, 1U);
    witness.add(update_of({0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}, 2, 0.05), Openness::blind);
    EXPECT_EQ(witness.evidence().unmatched, 1U);
}

/// The seam of a drive straight on with scores of 0.9, in which two updates turn by `turn_rad` each and have the given
/// scores.
MotionEvidence::Seam seam_of(double turn_rad, double first_score, double second_score,
                             Openness openness = Openness::held) {
    MotionWitness witness;
    std::uint64_t number = 0;
    const auto add = [&](double turned_rad, double score, Openness seen) {
        Update update = update_of({0.1, 0.0, turned_rad}, {0.1, 0.0, turned_rad}, number, score);
        update.matched.stamp_ns = update.corrected.stamp_ns = static_cast<std::int64_t>(1'000'000'000 * (number + 5));
        ++number;
        witness.add(update, seen);
    };
    for (int step = 0; step < 20; ++step) {
        const bool turning = step == 10 || step == 11;
        const double score = step == 10 ? first_score : step == 11 ? second_score : 0.9;
        add(turning ? turn_rad : 0.0, score, turning ? openness : Openness::held);
    }
    EXPECT_NEAR(witness.evidence().usual_score, 0.9, 0.01);
    return witness.evidence().seam;
}

TEST(MotionEvidence, TwoPoorFitsInATurnAreASeam) {
    const MotionEvidence::Seam seam = seam_of(0.5, 0.2, 0.4);
    EXPECT_NEAR(seam.score, 0.4, 1e-9);
    EXPECT_NEAR(seam.s, 11.0, 1e-9);
    EXPECT_NEAR(seam.moved_m, 0.2, 1e-9);
    EXPECT_NEAR(seam.turned_rad, 1.0, 1e-9);
}

TEST(MotionEvidence, NoSeamIsWhereTheNextScanFitsOrTheRobotHardlyMovesOrSeesNothing) {
    EXPECT_NEAR(seam_of(0.5, 0.2, 0.9).score, 0.9, 1e-9);
    EXPECT_EQ(seam_of(0.1, 0.2, 0.4).score, 1.0);
    EXPECT_EQ(seam_of(0.5, 0.2, 0.4, Openness::blind).score, 1.0);
}

TEST(MotionEvidence, WhatAddsUpOnAnOpenStretchIsFound) {
    const auto stalled = [](const Pose2& odometry, int) { return Pose2{0.9 * odometry.x_m, 0.0, odometry.theta_rad}; };
    const MotionEvidence open = driven(stalled, Openness::walls);
    EXPECT_NEAR(open.open.worst_stretch_m, 0.99, 1e-9);  // the first update does not begin at an open one
    EXPECT_NEAR(open.open.worst_length_m, 9.9, 1e-9);
    EXPECT_EQ(open.open.worst_updates, 99U);
    EXPECT_NEAR(open.open.worst_step_m, 0.01, 1e-9);
    EXPECT_EQ(driven(stalled, Openness::blind).open.worst_step_m, 0.0);
    EXPECT_EQ(driven(stalled).open.odometry_m, 0.0);
}

TEST(MotionEvidence, AShortHoldDoesNotPutRightWhatTheWheelsErredBefore) {
    const auto length_after_a_hold_of = [](int held_steps) {
        MotionWitness witness;
        for (int step = 0; step < 100 + held_steps; ++step) {
            witness.add(update_of({0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}),
                        step >= 80 && step < 80 + held_steps ? Openness::held : Openness::walls);
        }
        witness.add(update_of({0.1, 0.0, 0.0}, {1.1, 0.0, 0.0}), Openness::walls);
        return witness.evidence().open.worst_length_m;
    };
    EXPECT_NEAR(length_after_a_hold_of(5), 9.9, 1e-9);
    EXPECT_NEAR(length_after_a_hold_of(25), 2.0, 1e-9);
}

TEST(MotionEvidence, TurnsWithoutSightAddUp) {
    const auto turning = [](const Pose2& odometry, int) { return Pose2{odometry.x_m, 0.0, odometry.theta_rad + 0.01}; };
    EXPECT_NEAR(driven(turning, Openness::blind).open.worst_blind_turn_rad, 0.99, 1e-9);
    EXPECT_NEAR(driven(turning, Openness::blind).open.worst_blind_m, 9.9, 1e-9);
    EXPECT_EQ(driven(turning, Openness::walls).open.worst_blind_turn_rad, 0.0);
}

TEST(MotionEvidence, AHeldUpdateEndsAnOpenStretch) {
    MotionWitness witness;
    for (int step = 0; step < 100; ++step) {
        witness.add(update_of({0.1, 0.0, 0.0}, {0.09, 0.0, 0.0}), step % 10 == 0 ? Openness::held : Openness::walls);
    }
    EXPECT_LT(witness.evidence().open.worst_stretch_m, 0.1);
}

}  // namespace
}  // namespace ddtool::check
