#include "study/ablation/tables.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "fake_engine.hpp"
#include "known_dataset.hpp"

namespace ddtool::ablation {
namespace {

class TablesTest : public ::testing::Test {
protected:
    TablesTest() {
        Json json = default_plan_json();
        merge_settings(
            json,
            {{"seeds", {1, 2}},
             {"rows",
              {{{"name", "broken"}, {"train", {{"model", "broken"}}}},
               {{"name", "plain"}, {"paper", {{"accuracy", 0.9}}}}}},
             {"timings",
              {{{"row", "plain"}, {"paper_ms", 10}}, {{"row", "plain"}, {"device", "cuda"}}, {{"row", "broken"}}}}},
            "test");
        plan_ = plan_from_json(json);
    }

    ddtool::test::KnownDataset known_;
    ddtool::test::TemporaryFolder folder_;
    test::FakeEngine engine_;
    ModelStore store_{engine_, known_.folder(), folder_ / "runs", {}};
    Plan plan_;
};

TEST_F(TablesTest, ARowThatFailsSaysSoAndStopsNoOther) {
    const Json rows = accuracy_table(plan_, run_rows(plan_, store_), {}).json();
    EXPECT_EQ(rows[0].at("note"), "no such network");
    EXPECT_EQ(rows[0].at("seeds"), 0);
    EXPECT_TRUE(std::isnan(rows[0].at("accuracy").get<double>()));
    EXPECT_EQ(rows[1].at("seeds"), 2);
    EXPECT_EQ(rows[1].at("accuracy"), 0.5);
    EXPECT_EQ(rows[1].at("paper accuracy"), 0.9);
    EXPECT_EQ(rows[1].at("note"), "");
}

TEST_F(TablesTest, TimesWhatTheMachineCanRun) {
    const auto results = run_rows(plan_, store_);
    const Json rows = timing_table(plan_, run_timings(plan_, results, store_.data(), engine_)).json();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_GT(rows[0].at("time [ms]").get<double>(), 0.0);
    EXPECT_EQ(rows[0].at("paper [ms]"), 10.0);
    EXPECT_TRUE(std::isnan(rows[1].at("time [ms]").get<double>()));
    EXPECT_EQ(rows[1].at("note"), "there is no cuda");
    EXPECT_EQ(rows[2].at("note"), "the row has no model");
}

TEST_F(TablesTest, WhatIsThereIsNotTrainedAgain) {
    const auto first = run_rows(plan_, store_);
    EXPECT_EQ(engine_.trainings, 4U) << "two rows, two seeds";
    const auto again = run_rows(plan_, store_);
    EXPECT_EQ(engine_.trainings, 6U) << "the broken row is tried again";
    EXPECT_EQ(accuracy_table(plan_, first, {}).csv(), accuracy_table(plan_, again, {}).csv());
}

TEST_F(TablesTest, RulesStandBelowTheTrainings) {
    plan_.rules = {{"spread", "step", {.accuracy = 0.7}}};
    const std::vector<RowResult> none(plan_.rows.size());
    const Json rows = accuracy_table(plan_, none, run_rules(plan_, store_.data())).json();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[2].at("row"), "spread");
    EXPECT_EQ(rows[2].at("swarm"), "step");
    EXPECT_EQ(rows[2].at("accuracy"), 1.0) << "what KnownDataset is made for";
    EXPECT_EQ(rows[2].at("paper accuracy"), 0.7);
    plan_.rules = {{"spread", "of butter", {}}};
    EXPECT_THROW((void)run_rules(plan_, store_.data()), UsageError);
}

TEST_F(TablesTest, AStopEndsItAll) {
    engine_.stop = true;
    EXPECT_THROW((void)run_rows(plan_, store_), jobs::Stopped);
}

}  // namespace
}  // namespace ddtool::ablation
