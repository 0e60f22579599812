#include "trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bench_plan.hpp"
#include "trial_summary.hpp"

namespace ddtool::matcher_bench {
namespace {

/// A drive of 2 m towards a wall that is across it.
BenchWorld one_wall() {
    BenchWorld wall;
    wall.world.segments.push_back({{8.0, -50.0}, {8.0, 50.0}});
    wall.world.route.way_points.push_back({2.0, 0.0});
    wall.along_rad = 0.0;
    return wall;
}

/// A narrow bundle of n beams that hit a wall at a right angle measures the distance n times.
TEST(Trials, BoundOfOneWallIsTheNoiseOverTheRootOfTheNumberOfBeams) {
    constexpr int beams = 100;
    const sim::LidarSettings lidar{.beams = beams,
                                   .field_of_view_rad = 1e-3,
                                   .range_noise_m = 0.02,
                                   .drop_out_probability = 0.0,
                                   .beam_divergence_rad = 0.0};
    const TrialSettings settings;
    const std::vector<Trial> trials = match_at_frontier(drive_through(one_wall(), lidar, {}, 1), settings);
    ASSERT_GT(trials.size(), 10U);
    for (const Trial& trial : trials) {
        EXPECT_NEAR(trial.bound[along], lidar.range_noise_m / std::sqrt(beams), 1e-5);
        EXPECT_NEAR(trial.bound[across], settings.prior.sigma_across_m, 1e-3) << "a wall ahead says nothing of y";
    }
}

std::vector<Place> room_drive(std::uint64_t seed) {
    return drive_through(draw_world("room", 1, 0.0), usual_lidar, {}, seed);
}

class KnownRoom : public testing::Test {
protected:
    /// \param mapped_too_far_m the map is made of poses that are this much too far along x of the world
    static Summary summary(double mapped_too_far_m) {
        std::vector<Place> mapped = room_drive(1);
        for (Place& place : mapped) {
            place.frame.odom_from_robot.x_m += mapped_too_far_m;
        }
        std::vector<Place> places = room_drive(2);
        for (Place& place : places) {
            place.along_rad = 0.0;
        }
        return summarise({match_in_known_map(mapped, places, {})}, {}, {});
    }
};

TEST_F(KnownRoom, IsMatchedWithoutBias) {
    const Summary known = summary(0.0);
    EXPECT_EQ(known.lost, 0U);
    for (const Axis axis : {along, across}) {
        const Mean& bias = known.axes[axis].bias;
        EXPECT_LT(std::abs(bias.value), 3.0 * bias.standard_error + 2e-4) << axis;
    }
    EXPECT_LT(std::abs(known.axes[heading].bias.value), 2e-4);
}

/// No unbiased matcher has a smaller spread than the bound, and a good one is not far above it.
TEST_F(KnownRoom, IsMatchedWithASpreadNotBelowTheBound) {
    const Summary known = summary(0.0);
    for (const Axis axis : {along, across, heading}) {
        EXPECT_GT(known.axes[axis].spread, 0.9 * known.axes[axis].bound) << axis;
        EXPECT_LT(known.axes[axis].spread, 3.0 * known.axes[axis].bound) << axis;
    }
}

TEST_F(KnownRoom, ThatIsMappedTooFarShowsJustThatBias) {
    constexpr double too_far_m = 0.02;
    const Summary shifted = summary(too_far_m);
    EXPECT_NEAR(shifted.axes[along].bias.value, too_far_m, 1e-3);
    EXPECT_NEAR(shifted.axes[along].bias_displaced.value, too_far_m, 1e-3);
    EXPECT_GT(shifted.axes[along].first_step.value, 0.2 * too_far_m);
    EXPECT_LT(std::abs(shifted.axes[across].bias.value), 1e-3);
    EXPECT_GT(shifted.axes[along].normalised.value, 4.0 * shifted.axes[across].normalised.value);
}

TEST(Trials, ADisplacementIsTakenBackInARoom) {
    TrialSettings settings;
    settings.displacement_m = 0.08;
    const Summary summary = summarise({match_at_frontier(room_drive(1), settings)}, {}, {});
    for (const AxisSummary& axis : summary.axes) {
        EXPECT_LT(std::abs(axis.left), 0.1);
    }
}

/// A lidar that measures 2 % too far sees the walls ahead come nearer 2 % faster than the robot drives.
TEST(Trials, DriftIsTheShareByWhichTheWayComesOutTooLong) {
    std::vector<Place> places = room_drive(1);
    EXPECT_LT(std::abs(drift(places, {})), 1e-3);
    for (Place& place : places) {
        for (float& range_m : place.frame.scan.ranges_m) {
            range_m *= 1.02F;
        }
    }
    EXPECT_NEAR(drift(places, {}), 0.02, 0.003);
}

TEST(Plans, GiveTheSameFiguresEachTime) {
    Plan plan;
    plan.worlds = {"recesses", "room"};
    plan.cell_sizes_m = {0.05};
    plan.layouts = 1;
    plan.length_m = 15.0;
    const auto ignore = [](const CaseResult& /*result*/) {};
    const std::vector<CaseResult> once = run_plan(plan, ignore);
    const std::vector<CaseResult> again = run_plan(plan, ignore);
    ASSERT_EQ(once.size(), 2U);
    for (std::size_t index = 0; index < once.size(); ++index) {
        EXPECT_EQ(once[index].summary.axes[along].bias.value, again[index].summary.axes[along].bias.value);
        EXPECT_EQ(once[index].summary.axes[heading].spread, again[index].summary.axes[heading].spread);
        EXPECT_EQ(once[index].summary.drift.value, again[index].summary.drift.value);
    }
}

}  // namespace
}  // namespace ddtool::matcher_bench
