#include "study/ablation/reduced_plan.hpp"

#include <gmock/gmock.h>

namespace ddtool::ablation {
namespace {

/// Three seeds; a row of 30 and one of 3 epochs; two timings, one of them on a GPU.
Plan known_plan() {
    Plan plan;
    plan.seeds = {7, 8, 9};
    plan.rows.resize(2);
    plan.rows[0].settings.epochs = 30;
    plan.rows[1].settings.epochs = 3;
    plan.timings.resize(2);
    plan.timings[1].device = "cuda";
    return plan;
}

TEST(ReducedPlan, HasOneSeedAndOneEpochPerCore) {
    const Plan plan = reduced_plan(known_plan(), 4);
    EXPECT_EQ(plan.seeds, std::vector<std::uint64_t>{7});
    ASSERT_EQ(plan.rows.size(), 2U);
    EXPECT_EQ(plan.rows[0].settings.epochs, 4U);
    EXPECT_EQ(plan.rows[1].settings.epochs, 3U) << "no more than the whole plan has";
    ASSERT_EQ(plan.timings.size(), 1U);
    EXPECT_EQ(plan.timings[0].device, "cpu");
    EXPECT_EQ(reductions(known_plan(), plan), "1 of 3 seeds, 4 of 30 epochs, 1 of 2 timings");
}

TEST(ReducedPlan, HasMoreSeedsWhereTheCoresSufficeForAllEpochs) {
    EXPECT_EQ(reduced_plan(known_plan(), 59).seeds.size(), 1U);
    EXPECT_EQ(reduced_plan(known_plan(), 60).seeds, (std::vector<std::uint64_t>{7, 8}));
    const Plan plan = reduced_plan(known_plan(), 1000);
    EXPECT_EQ(plan.seeds, known_plan().seeds);
    EXPECT_EQ(plan.rows[0].settings.epochs, 30U);
}

TEST(ReducedPlan, SaysWhereNothingIsLeftOut) {
    EXPECT_EQ(reductions(known_plan(), known_plan()), "nothing is left out");
}

}  // namespace
}  // namespace ddtool::ablation
