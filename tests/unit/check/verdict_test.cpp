#include "check/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace ddtool::check {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A run of some minutes in which everything fits, with the small differences of healthy logs.
Evidence healthy() {
    Evidence evidence;
    evidence.scans = 500;
    evidence.all_scans = 500;
    evidence.blind_scans = 300;
    evidence.neighbours = {.pairs = 900, .contradicted = 0.01, .p90 = 0.05, .bad = 0.004};
    evidence.revisits = {.pairs = 900, .contradicted = 0.05, .p90 = 0.2, .bad = 0.09};
    evidence.odometry_revisits = {.pairs = 700, .contradicted = 0.4, .p90 = 0.9, .bad = 0.6};
    evidence.from_odometry_m = 5.0;
    evidence.motion = {.updates = 1000,
                       .odometry_m = 120.0,
                       .matched_m = 122.0,
                       .odometry_turn_rad = 40.0,
                       .along = 0.96,
                       .across = 0.012,
                       .turn = 0.95,
                       .lever_m = {0.05, -0.05},
                       .usual_m = 0.015,
                       .jumps = 4,
                       .worst_jump_m = 0.6,
                       .worst_jump_rad = 0.2,
                       .score = 0.9,
                       .usual_score = 0.9,
                       .unmatched = 10,
                       .seam = {.score = 0.3, .best_particle = 0.7, .s = 12.0, .moved_m = 0.4, .turned_rad = 1.4},
                       .open = {.odometry_m = 60.0,
                                .matched_m = 59.0,
                                .worst_stretch_m = 0.6,
                                .worst_length_m = 10.0,
                                .worst_updates = 50,
                                .worst_step_m = 0.2,
                                .worst_blind_turn_rad = 0.1,
                                .worst_blind_m = 20.0}};
    evidence.steps = {.moving = 900, .stairs = 3, .lost = 0, .longest_lost_s = 0.0, .usual_m_per_s = 0.5};
    return evidence;
}

struct Fault {
    const char* reason;
    std::function<void(Evidence&)> add;
    Standing standing = Standing::doubtful;
};

std::vector<Fault> faults() {
    return {
        {"taken right after each other contradict", [](Evidence& e) { e.neighbours.bad = 0.1; }},
        {"taken right after each other contradict", [](Evidence& e) { e.neighbours.bad = 0.5; }, Standing::refuted},
        {"at different times contradict each other", [](Evidence& e) { e.revisits.bad = 0.22; }},
        {"at different times contradict each other", [](Evidence& e) { e.revisits.bad = 0.7; }, Standing::refuted},
        {"for each metre of odometry the scans moved the robot by 1.30 m",
         [](Evidence& e) {
             e.motion.along = 1.3;
             e.motion.matched_m = 1.3 * e.motion.odometry_m;
         }},
        {"turned the robot by -1.00 degrees, the other way round", [](Evidence& e) { e.motion.turn = -1.0; }},
        {"the robot drives 17 degrees to the left", [](Evidence& e) { e.motion.across = 0.3; }},
        {"turns about a point 0.50 m from its origin",
         [](Evidence& e) {
             e.motion.lever_m = {0.4, 0.3};
         }},
        {"the matched poses tremble", [](Evidence& e) { e.motion.matched_m = 1.2 * e.motion.odometry_m; }},
        {"at 30 of 1000 updates the match left the odometry", [](Evidence& e) { e.motion.jumps = 30; }},
        {"the path departs from the odometry by 4.30 m", [](Evidence& e) { e.motion.open.worst_stretch_m = 4.3; }},
        {"at a single update", [](Evidence& e) { e.motion.open.worst_step_m = 0.7; }},
        {"the path turns away from the odometry by 34 degrees",
         [](Evidence& e) { e.motion.open.worst_blind_turn_rad = 0.6; }},
        {"200 of 1000 scans fit the map nowhere", [](Evidence& e) { e.motion.unmatched = 200; }},
        {"12 s after the first scan, two scans in a row fit the map with scores of at most 0.41, where 0.90 is usual, "
         "while the robot moved by 0.40 m and turned by 80 degrees",
         [](Evidence& e) {
             e.motion.seam.score = 0.41;
             e.motion.seam.best_particle = 0.52;
         }},
        {"stands still and then leaps, 400 times", [](Evidence& e) { e.steps.stairs = 400; }},
        {"the scans pause 1 time (up to 20.0 s)",
         [](Evidence& e) {
             e.steps.lost = 1;
             e.steps.longest_lost_s = 20.0;
         }},
        {"490 of 500 scans have no beam with a range", [](Evidence& e) { e.blind_scans = 490; }},
        {"the odometry drives at 62 m/s", [](Evidence& e) { e.steps.usual_m_per_s = 62.0; }},
        {"the odometry alone leads back to where it was",
         [](Evidence& e) { e.odometry_revisits = {.pairs = 850, .contradicted = 0.05, .p90 = 0.2, .bad = 0.1}; }},
    };
}

TEST(Verdict, AFewBlindScansSayNothingUnlessAllAre) {
    Evidence evidence = healthy();
    evidence.all_scans = 6;
    evidence.blind_scans = 5;
    EXPECT_EQ(verdict_of(evidence).standing, Standing::plausible);
    evidence.blind_scans = 6;
    EXPECT_EQ(verdict_of(evidence).standing, Standing::doubtful);
}

TEST(Verdict, NothingSpeaksAgainstAHealthyRun) {
    const Verdict verdict = verdict_of(healthy());
    EXPECT_EQ(verdict.standing, Standing::plausible);
    EXPECT_THAT(verdict.reasons, IsEmpty());
}

TEST(Verdict, WhatTheUsualDifferencesAddUpToDepartsFromNothing) {
    Evidence evidence = healthy();
    evidence.motion.open.worst_stretch_m = 2.2;
    evidence.motion.open.worst_updates = 300;
    evidence.motion.usual_m = 0.005;
    EXPECT_EQ(verdict_of(evidence).standing, Standing::doubtful);
    evidence.motion.usual_m = 0.05;
    EXPECT_EQ(verdict_of(evidence).standing, Standing::plausible);
}

TEST(Verdict, AnOdometryThatSeldomLeadsBackProvesNothing) {
    Evidence evidence = healthy();
    evidence.odometry_revisits = {.pairs = 200, .contradicted = 0.0, .p90 = 0.0, .bad = 0.0};
    EXPECT_THAT(verdict_of(evidence).reasons, IsEmpty());
}

TEST(Verdict, ARunWithoutAnythingIsPlausible) { EXPECT_THAT(verdict_of({}).reasons, IsEmpty()); }

TEST(Verdict, EachFaultGivesItsReasonAlone) {
    for (const Fault& fault : faults()) {
        Evidence evidence = healthy();
        fault.add(evidence);
        const Verdict verdict = verdict_of(evidence);
        EXPECT_EQ(verdict.standing, fault.standing) << fault.reason;
        EXPECT_THAT(verdict.reasons, ElementsAre(HasSubstr(fault.reason)));
    }
}

TEST(Verdict, AShortRunIsNotJudgedByTooLittle) {
    Evidence evidence = healthy();
    evidence.neighbours = {.pairs = 10, .contradicted = 0.5, .p90 = 1.0, .bad = 0.5};
    evidence.revisits = evidence.odometry_revisits = evidence.neighbours;
    evidence.motion.odometry_m = 2.0;
    evidence.motion.matched_m = 3.0;
    evidence.motion.odometry_turn_rad = 0.5;
    evidence.motion.along = evidence.motion.turn = 0.5;
    evidence.motion.across = 0.3;
    evidence.motion.lever_m = {1.0, 0.0};
    EXPECT_THAT(verdict_of(evidence).reasons, IsEmpty());
}

TEST(Verdict, TheWorstReasonDecides) {
    Evidence evidence = healthy();
    evidence.revisits.bad = 0.7;
    evidence.steps.lost = 1;
    const Verdict verdict = verdict_of(evidence);
    EXPECT_EQ(verdict.standing, Standing::refuted);
    EXPECT_EQ(verdict.reasons.size(), 2U);
    const Json json = self_check_json(verdict, evidence);
    EXPECT_EQ(json.at("verdict"), "refuted");
    EXPECT_EQ(json.at("reasons").size(), 2U);
    EXPECT_EQ(json.at("evidence").at("revisits").at("bad"), 0.7);
}

}  // namespace
}  // namespace ddtool::check
