#include "scores/absolute_error.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "wandering_path.hpp"

namespace ddtool {
namespace {

const Pose2 some_motion{-7.0, 40.0, 2.9};

TEST(AbsoluteError, OfTheReferenceItselfIsZero) {
    const Trajectory path = wandering_path(50, 1);
    const AteResult result = absolute_trajectory_error(path, path);
    EXPECT_EQ(result.translation_m.count, path.size());
    EXPECT_NEAR(result.translation_m.max, 0.0, 1e-9);
}

TEST(AbsoluteError, WithSe2IgnoresARigidMotionOfTheEstimate) {
    const Trajectory reference = wandering_path(80, 2);
    const Trajectory estimate = noisy(reference, 3);
    const AteResult here = absolute_trajectory_error(estimate, reference);
    const AteResult there = absolute_trajectory_error(moved(estimate, some_motion), reference);
    EXPECT_GT(here.translation_m.rmse, 0.01);
    EXPECT_NEAR(there.translation_m.rmse, here.translation_m.rmse, 1e-9);
    EXPECT_NEAR(there.error_x_m.mean, here.error_x_m.mean, 1e-9);
}

TEST(AbsoluteError, RecoversTheMotionItIsGranted) {
    const Trajectory reference = wandering_path(40, 4);
    for (const Alignment alignment : {Alignment::first, Alignment::se2}) {
        const AteResult result =
            absolute_trajectory_error(moved(reference, inverse(some_motion)), reference, {.alignment = alignment});
        const Pose2 difference = between(some_motion, result.reference_from_estimate);
        EXPECT_NEAR(std::hypot(difference.x_m, difference.y_m), 0.0, 1e-9);
        EXPECT_NEAR(difference.theta_rad, 0.0, 1e-9);
    }
}

TEST(AbsoluteError, WithSe2IsTheLeastOfAllRigidMotions) {
    const Trajectory reference = wandering_path(60, 5);
    const AteResult best = absolute_trajectory_error(noisy(reference, 6), reference);
    for (const Pose2& nudge :
         {Pose2{1e-3, 0, 0}, Pose2{-1e-3, 0, 0}, Pose2{0, 1e-3, 0}, Pose2{0, 0, 1e-3}, Pose2{0, 0, -1e-3}}) {
        double squares = 0.0;
        for (const PosePair& pair : best.pairs) {
            squares += std::pow(distance_m(nudge * pair.estimate, pair.reference), 2);
        }
        EXPECT_GT(std::sqrt(squares / static_cast<double>(best.pairs.size())), best.translation_m.rmse);
    }
}

TEST(AbsoluteError, OfAStraightPathIsNotReflected) {
    Trajectory reference;
    for (int i = 0; i < 20; ++i) {
        reference.push_back({i * 100'000'000LL, {0.5 * i, 0.0, 0.0}});
    }
    const AteResult result = absolute_trajectory_error(moved(reference, some_motion), reference);
    EXPECT_NEAR(result.pairs.back().estimate.theta_rad, 0.0, 1e-9);
}

TEST(AbsoluteError, WithoutAlignmentIsTheOffset) {
    const Trajectory reference = wandering_path(30, 7);
    const AteResult result =
        absolute_trajectory_error(moved(reference, {3.0, -4.0, 0.0}), reference, {.alignment = Alignment::none});
    EXPECT_NEAR(result.translation_m.rmse, 5.0, 1e-9);
    EXPECT_NEAR(result.translation_m.std, 0.0, 1e-6);
    EXPECT_NEAR(result.error_x_m.mean, 3.0, 1e-9);
    EXPECT_NEAR(result.error_y_m.mean, 4.0, 1e-9);
}

TEST(AbsoluteError, GrowsWithTheScaleOfTheWorld) {
    const auto doubled = [](Trajectory path) {
        for (StampedPose& stamped : path) {
            stamped.pose.x_m *= 2.0;
            stamped.pose.y_m *= 2.0;
        }
        return path;
    };
    const Trajectory reference = wandering_path(60, 8);
    const Trajectory estimate = noisy(reference, 9);
    EXPECT_NEAR(absolute_trajectory_error(doubled(estimate), doubled(reference)).translation_m.rmse,
                2.0 * absolute_trajectory_error(estimate, reference).translation_m.rmse, 1e-9);
}

TEST(AbsoluteError, DoesNotDependOnTheOrderOfThePoses) {
    const Trajectory reference = wandering_path(60, 10);
    Trajectory estimate = noisy(reference, 11);
    const double in_order = absolute_trajectory_error(estimate, reference).translation_m.rmse;
    std::reverse(estimate.begin(), estimate.end());
    EXPECT_NEAR(absolute_trajectory_error(estimate, reference).translation_m.rmse, in_order, 1e-9);
}

TEST(AbsoluteError, NeedsAMomentInCommon) {
    const Trajectory early{{0, {}}};
    const Trajectory late{{1'000'000'000, {}}};
    EXPECT_THROW(absolute_trajectory_error(early, late), Error);
    EXPECT_THROW(absolute_trajectory_error({}, late), Error);
}

TEST(ErrorStatistics, AreThoseOfEvo) {
    const ErrorStatistics statistics = error_statistics(std::vector{1.0, 2.0, 3.0, 6.0});
    EXPECT_EQ(statistics.count, 4U);
    EXPECT_DOUBLE_EQ(statistics.rmse, std::sqrt(12.5));
    EXPECT_DOUBLE_EQ(statistics.mean, 3.0);
    EXPECT_DOUBLE_EQ(statistics.median, 2.5);
    EXPECT_DOUBLE_EQ(statistics.std, std::sqrt(3.5));
    EXPECT_DOUBLE_EQ(statistics.min, 1.0);
    EXPECT_DOUBLE_EQ(statistics.max, 6.0);
}

TEST(ErrorStatistics, OfNothingAreMissing) {
    const ErrorStatistics statistics = error_statistics({});
    EXPECT_EQ(statistics.count, 0U);
    EXPECT_TRUE(std::isnan(statistics.rmse));
}

TEST(Alignment, NamesAreChecked) {
    EXPECT_EQ(parse_alignment("first"), Alignment::first);
    EXPECT_THROW(parse_alignment("se3"), UsageError);
}

}  // namespace
}  // namespace ddtool
