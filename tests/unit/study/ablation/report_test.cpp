#include "study/ablation/report.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "fake_engine.hpp"
#include "known_dataset.hpp"

namespace ddtool::ablation {
namespace {

class ReportTest : public ::testing::Test {
protected:
    ReportTest() {
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

TEST_F(ReportTest, ARowThatFailsSaysSoAndStopsNoOther) {
    const Json rows = accuracy_table(plan_, run_rows(plan_, store_)).json();
    EXPECT_EQ(rows[0].at("note"), "no such network");
    EXPECT_EQ(rows[0].at("seeds"), 0);
    EXPECT_TRUE(std::isnan(rows[0].at("accuracy").get<double>()));
    EXPECT_EQ(rows[1].at("seeds"), 2);
    EXPECT_EQ(rows[1].at("accuracy"), 0.5);
    EXPECT_EQ(rows[1].at("paper accuracy"), 0.9);
    EXPECT_EQ(rows[1].at("note"), "");
}

TEST_F(ReportTest, TimesWhatTheMachineCanRun) {
    const auto results = run_rows(plan_, store_);
    const Json rows = timing_table(plan_, run_timings(plan_, results, store_.data(), engine_)).json();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_GT(rows[0].at("time [ms]").get<double>(), 0.0);
    EXPECT_EQ(rows[0].at("paper [ms]"), 10.0);
    EXPECT_TRUE(std::isnan(rows[1].at("time [ms]").get<double>()));
    EXPECT_EQ(rows[1].at("note"), "there is no cuda");
    EXPECT_EQ(rows[2].at("note"), "the row has no model");
}

TEST_F(ReportTest, AStopEndsItAll) {
    engine_.stop = true;
    EXPECT_THROW((void)run_rows(plan_, store_), TrainingStopped);
}

}  // namespace
}  // namespace ddtool::ablation
