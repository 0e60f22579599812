#include "scores/relative_error.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ddtool/base/error.hpp"
#include "wandering_path.hpp"

namespace ddtool {
namespace {

std::vector<PosePair> pairs_of(const Trajectory& estimate, const Trajectory& reference) {
    return associate(estimate, reference, default_max_time_difference_s);
}

/// A straight drive at 1 m/s with a pose every 0.1 s. The estimate is longer than the truth by the given factor.
std::vector<PosePair> straight_drive(std::size_t poses, double estimate_scale) {
    std::vector<PosePair> pairs;
    for (std::size_t i = 0; i < poses; ++i) {
        const double x_m = 0.1 * static_cast<double>(i);
        pairs.push_back({static_cast<std::int64_t>(i) * 100'000'000, {estimate_scale * x_m, 0, 0}, {x_m, 0, 0}});
    }
    return pairs;
}

TEST(RelativeError, OfAConstantScaleErrorIsTheSameForEveryMotion) {
    const RpeResult result = relative_pose_error(straight_drive(11, 1.1), {5.0, DeltaUnit::frames});
    EXPECT_EQ(result.translation_m.count, 2U) << "motions follow each other without overlap";
    EXPECT_NEAR(result.translation_m.min, 0.05, 1e-12);
    EXPECT_NEAR(result.translation_m.max, 0.05, 1e-12);
    EXPECT_NEAR(result.rotation_deg.max, 0.0, 1e-12);
}

TEST(RelativeError, OfAConstantTurnIsItsAngle) {
    std::vector<PosePair> pairs = straight_drive(11, 1.0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i].estimate.theta_rad = wrap_angle(0.4 * static_cast<double>(i));
    }
    const RpeResult result = relative_pose_error(pairs);
    EXPECT_EQ(result.rotation_deg.count, 10U);
    EXPECT_NEAR(result.rotation_deg.min, 0.4 * 180.0 / std::acos(-1.0), 1e-9);
    EXPECT_NEAR(result.rotation_deg.max, result.rotation_deg.min, 1e-9);
}

TEST(RelativeError, IgnoresWhereEitherFrameIs) {
    const Trajectory reference = wandering_path(60, 1);
    const Trajectory estimate = noisy(reference, 2);
    for (const RpeDelta delta :
         {RpeDelta{1.0, DeltaUnit::frames}, RpeDelta{0.5, DeltaUnit::metres}, RpeDelta{0.45, DeltaUnit::seconds}}) {
        const RpeResult here = relative_pose_error(pairs_of(estimate, reference), delta);
        const RpeResult there =
            relative_pose_error(pairs_of(moved(estimate, {5, 6, 1}), moved(reference, {-9, 0, 3})), delta);
        EXPECT_GT(here.translation_m.count, 5U);
        EXPECT_EQ(there.translation_m.count, here.translation_m.count);
        EXPECT_NEAR(there.translation_m.rmse, here.translation_m.rmse, 1e-9);
        EXPECT_NEAR(there.rotation_deg.rmse, here.rotation_deg.rmse, 1e-9);
    }
}

TEST(RelativeError, CountsMetresAlongTheEstimateAndSecondsOfItsStamps) {
    // The nodes are at 0.4, 0.8, ... metres of the estimate. As in evo, the first one is where the first motion begins.
    const RpeResult by_path = relative_pose_error(straight_drive(21, 2.0), {0.39, DeltaUnit::metres});
    EXPECT_EQ(by_path.translation_m.count, 9U);
    EXPECT_NEAR(by_path.translation_m.mean, 0.2, 1e-9);
    const RpeResult by_time = relative_pose_error(straight_drive(21, 2.0), {0.39, DeltaUnit::seconds});
    EXPECT_EQ(by_time.translation_m.count, 4U);
    EXPECT_NEAR(by_time.translation_m.mean, 0.4, 1e-9);
}

TEST(RelativeError, OfTooShortAPathIsMissing) {
    EXPECT_EQ(relative_pose_error(straight_drive(1, 1.0)).translation_m.count, 0U);
    EXPECT_EQ(relative_pose_error(straight_drive(5, 1.0), {9.0, DeltaUnit::metres}).translation_m.count, 0U);
}

TEST(RelativeError, RefusesImpossibleDeltas) {
    for (const double delta : {0.0, -1.0, 1.5, 1e30, std::nan("")}) {
        EXPECT_THROW(relative_pose_error(straight_drive(5, 1.0), {delta, DeltaUnit::frames}), UsageError) << delta;
    }
    EXPECT_THROW(relative_pose_error({}, {0.0, DeltaUnit::metres}), UsageError);
    EXPECT_THROW(parse_delta_unit("feet"), UsageError);
}

}  // namespace
}  // namespace ddtool
