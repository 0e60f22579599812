#include "trial_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool::matcher_bench {
namespace {

TEST(BlockMean, HasTheUsualStandardErrorIfEveryValueIsABlock) {
    BlockMean mean;
    for (std::uint64_t block = 0; block < 4; ++block) {
        mean.add(block, block % 2 == 0 ? 1.0 : 3.0);
    }
    EXPECT_EQ(mean.mean().value, 2.0);
    EXPECT_NEAR(mean.mean().standard_error, std::sqrt(4.0 / 3.0) / 2.0, 1e-12);
}

/// Ten times the same value tell no more than one.
TEST(BlockMean, CountsABlockOfEqualValuesOnce) {
    BlockMean once;
    BlockMean ten_times;
    for (std::uint64_t block = 0; block < 6; ++block) {
        const double value = std::sin(static_cast<double>(block));
        once.add(block, value);
        for (int i = 0; i < 10; ++i) {
            ten_times.add(block, value);
        }
    }
    EXPECT_NEAR(ten_times.mean().standard_error, once.mean().standard_error, 1e-12);
}

TEST(BlockMean, OfOneBlockHasNoStandardErrorAndOfNoneNoValue) {
    BlockMean mean;
    EXPECT_TRUE(std::isnan(mean.mean().value));
    mean.add(7, 2.0);
    EXPECT_EQ(mean.mean().value, 2.0);
    EXPECT_TRUE(std::isnan(mean.mean().standard_error));
}

constexpr double believed_m = 0.004;

/// Errors of a matcher that is off by bias_m along, spreads by spread_m, and believes believed_m.
std::vector<Trial> drawn_trials(double bias_m, double spread_m, int count) {
    RandomStream random({1});
    std::vector<Trial> trials;
    for (int i = 0; i < count; ++i) {
        Trial trial{.way_m = 0.1 * i,
                    .accepted = true,
                    .first_step = Eigen::Vector3d::Zero(),
                    .error = spread_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal()),
                    .displacement = 0.05 * Eigen::Vector3d(random.normal(), random.normal(), random.normal()),
                    .error_displaced = Eigen::Vector3d::Zero(),
                    .bound = Eigen::Vector3d::Constant(0.002),
                    .believed = Eigen::Vector3d::Constant(believed_m)};
        trial.error[along] += bias_m;
        trial.error_displaced = trial.error + 0.25 * trial.displacement;
        trials.push_back(trial);
    }
    return trials;
}

TEST(Summary, StatesBiasSpreadBeliefAndWhatIsLeftOfADisplacement) {
    const Summary summary = summarise({drawn_trials(0.003, believed_m, 20'000)}, {0.01, 0.03}, {});
    const AxisSummary& axis = summary.axes[along];
    EXPECT_EQ(summary.matches, 20'000U);
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_NEAR(axis.bias.value, 0.003, 4.0 * axis.bias.standard_error);
    EXPECT_NEAR(axis.bias.standard_error, believed_m / std::sqrt(20'000.0), 5e-6);
    EXPECT_NEAR(axis.spread, believed_m, 1e-4);
    EXPECT_NEAR(axis.bound, 0.002, 1e-12);
    EXPECT_NEAR(axis.left, 0.25, 0.01);
    EXPECT_NEAR(axis.believed, believed_m, 1e-12);
    EXPECT_NEAR(summary.axes[across].normalised.value, 1.0, 0.05) << "the belief is right";
    EXPECT_NEAR(axis.normalised.value, 1.0 + 9.0 / 16.0, 0.1) << "a bias makes the belief too sure";
    EXPECT_NEAR(summary.drift.value, 0.02, 1e-12);
    EXPECT_NEAR(summary.drift.standard_error, 0.01, 1e-12);
}

TEST(Summary, LeavesOutAnAxisThatTheScanDoesNotHold) {
    std::vector<Trial> trials = drawn_trials(0.0, believed_m, 200);
    for (Trial& trial : trials) {
        trial.bound[along] = 0.5;
        trial.error[along] += 5.0;  // nobody can know, so the match is not lost
    }
    const Summary summary = summarise({trials}, {}, {});
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_EQ(summary.axes[along].held, 0U);
    EXPECT_TRUE(std::isnan(summary.axes[along].bias.value));
    EXPECT_NEAR(summary.axes[along].believed, believed_m, 1e-12) << "what is believed of it is shown all the same";
    EXPECT_EQ(summary.axes[across].held, 200U);
}

TEST(Summary, CountsLostMatchesAndLeavesThemOut) {
    std::vector<Trial> trials = drawn_trials(0.0, believed_m, 200);
    trials[3].error[across] = 0.4;
    trials[4].error_displaced[heading] = 0.5;
    trials[5].accepted = false;
    const Summary summary = summarise({trials}, {}, {});
    EXPECT_EQ(summary.matches, 200U);
    EXPECT_EQ(summary.lost, 3U);
    EXPECT_EQ(summary.axes[across].held, 197U);
    EXPECT_LT(summary.axes[across].spread, 0.01);
}

}  // namespace
}  // namespace ddtool::matcher_bench
