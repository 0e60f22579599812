#include "robot/sweep_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ddtool/base/random.hpp"
#include "robot/scan_alignment.hpp"
#include "robot/sweep.hpp"
#include "swept_scans.hpp"

namespace ddtool {
namespace {

using test::SweptScans;

/// The order that a trial finds: 0, 1 or -1 as in SweptScans.
int order_found(int order, int assumed, double noise_m, double speed = 1.0) {
    std::vector<int> candidates{assumed};
    for (const int other : {0, 1, -1}) {
        if (other != assumed) {
            candidates.push_back(other);
        }
    }
    SweepTrial trial(candidates.size());
    RandomStream random{3};
    for (int i = 0; i < 60; ++i) {
        const double t_s = speed * SweptScans::scan_every_s * i;
        SensorFrame frame = SweptScans{.order = order}.scan_at(t_s);
        frame.scan.stamp_ns = std::llround(1e9 * SweptScans::scan_every_s * i);
        for (float& range : frame.scan.ranges_m) {
            range += static_cast<float>(noise_m * random.normal());
        }
        std::vector<std::vector<Pose2>> sweeps;
        for (const int candidate : candidates) {
            sweeps.push_back(
                sweep_of(frame.scan, candidate * SweptScans::turn_s / SweptScans::beams,
                         [&](double seconds) { return std::optional(SweptScans::robot_at(t_s + seconds)); }));
        }
        trial.add(frame, sweeps);
    }
    return candidates[trial.chosen()];
}

TEST(SweepTrial, FindsHowTheBeamsAreMeasuredWhateverIsAssumed) {
    for (const double noise_m : {0.0, 0.03}) {
        for (const int order : {0, 1, -1}) {
            for (const int assumed : {0, 1, -1}) {
                EXPECT_EQ(order_found(order, assumed, noise_m), order) << assumed << " " << noise_m;
            }
        }
    }
}

TEST(SweepTrial, LeavesWhatIsAssumedWhereTheRobotHardlyMoves) {
    for (const int assumed : {0, 1, -1}) {
        EXPECT_EQ(order_found(0, assumed, 0.01, 0.0), assumed);
    }
}

TEST(ScanAlignment, FindsTheMotionBetweenTwoScans) {
    std::vector<Point2> first;
    std::vector<Point2> second;
    const Pose2 first_from_second{0.08, -0.05, 0.06};
    for (const double t_s : {0.0, 1.0}) {
        const SensorFrame frame = SweptScans{.order = 0}.scan_at(0.0);
        for (std::size_t beam = 0; beam < frame.scan.ranges_m.size(); ++beam) {
            const auto range_m = static_cast<double>(frame.scan.ranges_m[beam]);
            const double angle_rad = frame.scan.angle_rad(beam);
            const Point2 end{range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)};
            (t_s == 0.0 ? first : second).push_back(t_s == 0.0 ? end : inverse(first_from_second) * end);
        }
    }
    const ScanAlignment found = align_scans(first, second, {});
    EXPECT_LT(distance_m(found.first_from_second, first_from_second), 0.003);
    EXPECT_NEAR(found.first_from_second.theta_rad, first_from_second.theta_rad, 0.001);
    EXPECT_LT(found.residual_m, 0.005);
    EXPECT_GT(found.matched_share, 0.95);
}

TEST(ScanAlignment, KeepsTheGuessWithoutPoints) {
    const Pose2 guess{1.0, 2.0, 0.5};
    EXPECT_EQ(align_scans({}, {{1.0, 1.0}}, guess).first_from_second, guess);
    EXPECT_EQ(align_scans({{1.0, 1.0}}, {}, guess).first_from_second, guess);
}

}  // namespace
}  // namespace ddtool
